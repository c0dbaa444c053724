// From intensity and opacity to pixels and back.
#pragma once

#include <QPointF>
#include <QRectF>
#include <vector>

#include "processing/opacity_curve.h"

namespace echolucent {

/// The part of [0,1] that one axis shows.
struct AxisRange {
    double lower = 0.0;
    double upper = 1.0;

    [[nodiscard]] double length() const { return upper - lower; }
    /// Length times `factor` with `anchor` kept where it is on the screen; within [0,1], no shorter than `minLength`.
    [[nodiscard]] AxisRange zoomed(double anchor, double factor, double minLength) const;
    /// Moved by `distance`, stopped at 0 and 1.
    [[nodiscard]] AxisRange moved(double distance) const;
    friend bool operator==(const AxisRange&, const AxisRange&) = default;
};

/// Shortest ranges that zooming reaches: 8 of 256 intensities, and an opacity of 0.005 (adaptive ones can be small).
inline constexpr double minIntensityLength = 8.0 / 256.0;
inline constexpr double minOpacityLength = 0.005;

/// A rectangle in pixels that shows a range of intensities to the right and one of opacities upwards.
struct PlotAxes {
    QRectF rect;
    AxisRange intensity;
    AxisRange opacity;

    [[nodiscard]] QPointF positionOf(const CurveNode& value) const;
    /// Inverse of positionOf; not clamped.
    [[nodiscard]] CurveNode valueAt(QPointF position) const;
};

/// Round positions (1, 2 or 5 times a power of ten apart) in the range, at most `maxCount` (>= 2) of them.
[[nodiscard]] std::vector<double> tickPositions(const AxisRange& range, int maxCount);

}  // namespace echolucent
