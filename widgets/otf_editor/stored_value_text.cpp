#include "widgets/otf_editor/stored_value_text.h"

#include <cmath>

namespace echolucent {

QString storedValueText(double value, double whiteLevel) {
    constexpr double leastWhole = 100.0, mostWhole = 1e7;
    if (whiteLevel >= leastWhole && whiteLevel <= mostWhole && std::abs(value) <= 2 * mostWhole)
        return QString::number(std::lround(value));
    return QString::number(value, 'g', 3);
}

}  // namespace echolucent
