// Maps intensity and opacity to pixels and back.
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
    /// Length times `factor`, within [0,1] and no shorter than `minLength`. `anchor` keeps its place on the screen,
    /// unless the range would leave [0,1].
    [[nodiscard]] AxisRange zoomed(double anchor, double factor, double minLength) const;
    /// Moved by `distance`, stopped at 0 and 1.
    [[nodiscard]] AxisRange moved(double distance) const;
    friend bool operator==(const AxisRange&, const AxisRange&) = default;
};

/// The shortest ranges when zooming: 8 of 256 intensities, and an opacity of 0.005 (adaptive ones can be small).
inline constexpr double minIntensityLength = 8.0 / 256.0;
inline constexpr double minOpacityLength = 0.005;

/// A rectangle in pixels. Intensities go to the right, opacities upwards.
struct PlotAxes {
    QRectF rect;
    AxisRange intensity;
    AxisRange opacity;

    [[nodiscard]] QPointF positionOf(const CurveNode& value) const;
    /// Inverse of positionOf; not clamped.
    [[nodiscard]] CurveNode valueAt(QPointF position) const;
};

/// Round positions in the range, 1, 2 or 5 times a power of ten apart: at most `maxCount` (>= 2).
[[nodiscard]] std::vector<double> tickPositions(const AxisRange& range, int maxCount);

}  // namespace echolucent
