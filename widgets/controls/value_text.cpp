#include "widgets/controls/value_text.h"

#include <algorithm>
#include <cmath>

#include "processing/volume/value_digits.h"

namespace echolucent {

QString valueText(double value, const ValueWindow& window) {
    constexpr double leastWhole = 100.0, mostWhole = 1e7;
    const double width = window.white - window.black;
    const double farthest = std::max(std::abs(window.black), std::abs(window.white));
    if (width >= leastWhole && width <= mostWhole && std::max(std::abs(value), farthest) <= 2 * mostWhole)
        return QString::number(std::lround(value));
    // Rounding of the window's ends leaves traces beside 0.
    const bool isZero = std::abs(value) < 1e-9 * width;
    return isZero ? QStringLiteral("0") : QString::number(value, 'g', digitsToTell(window, 3));
}

QString valueBeside(double intensity, const ValueWindow& window) {
    if (window.isNormalised()) return {};
    return QStringLiteral(" (%1)").arg(valueText(window.valueAt(intensity), window));
}

}  // namespace echolucent
