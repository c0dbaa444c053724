#include "widgets/otf_editor/plot_axes.h"

#include <algorithm>
#include <cmath>

namespace echolucent {

namespace {

double roundStepAtLeast(double step) {
    const double power = std::pow(10.0, std::floor(std::log10(step)));
    for (const double multiple : {1.0, 2.0, 5.0})
        if (multiple * power >= step * (1.0 - 1e-9)) return multiple * power;
    return 10.0 * power;
}

}  // namespace

AxisRange AxisRange::zoomed(double anchor, double factor, double minLength) const {
    const double newLength = std::clamp(length() * factor, minLength, 1.0);
    const double share = (anchor - lower) / length();
    const double newLower = std::clamp(anchor - share * newLength, 0.0, 1.0 - newLength);
    return {newLower, newLower + newLength};
}

AxisRange AxisRange::moved(double distance) const {
    const double newLower = std::clamp(lower + distance, 0.0, 1.0 - length());
    return {newLower, newLower + length()};
}

QPointF PlotAxes::positionOf(const CurveNode& value) const {
    return {rect.left() + rect.width() * (value.intensity - intensity.lower) / intensity.length(),
            rect.bottom() - rect.height() * (value.opacity - opacity.lower) / opacity.length()};
}

CurveNode PlotAxes::valueAt(QPointF position) const {
    return {intensity.lower + intensity.length() * (position.x() - rect.left()) / rect.width(),
            opacity.lower + opacity.length() * (rect.bottom() - position.y()) / rect.height()};
}

std::vector<double> tickPositions(const AxisRange& range, int maxCount) {
    const double step = roundStepAtLeast(range.length() / std::max(1, maxCount - 1));
    std::vector<double> positions;
    const auto first = static_cast<long>(std::ceil(range.lower / step - 1e-6));
    const auto last = static_cast<long>(std::floor(range.upper / step + 1e-6));
    for (long i = first; i <= last; ++i) positions.push_back(static_cast<double>(i) * step);
    return positions;
}

}  // namespace echolucent
