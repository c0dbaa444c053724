// The legend of colours beside a picture that is coloured by its shown depths.
#pragma once

#include <QColor>
#include <QFontMetrics>
#include <QImage>
#include <QPainter>
#include <QRect>
#include <QString>
#include <optional>
#include <vector>

#include "processing/comparison/shown_depth.h"

namespace echolucent {

struct SurfaceLegendEntry {
    ShownSurface shown;
    std::optional<int> percent{};  ///< of the rays; none: the legend of several pictures
    friend bool operator==(const SurfaceLegendEntry&, const SurfaceLegendEntry&) = default;
};
using SurfaceLegend = std::vector<SurfaceLegendEntry>;

/// The four colours with the shares of a picture, or without shares.
[[nodiscard]] SurfaceLegend surfaceLegend(const std::optional<ShownDepth>& depth);
/// How wide the legend is with all its words, pixels.
[[nodiscard]] int surfaceLegendWidth(const SurfaceLegend& legend, const QFontMetrics& metrics);
/// A sample of each colour with its pattern, and its words, in one line as high as the rectangle. If the line is short,
/// signs of percent are left out, then the shares.
void paintSurfaceLegend(QPainter& painter, const QRect& line, const SurfaceLegend& legend, const QColor& text);
/// The picture with its legend below, for a file.
[[nodiscard]] QImage withSurfaceLegend(const QImage& picture, const SurfaceLegend& legend);

}  // namespace echolucent
