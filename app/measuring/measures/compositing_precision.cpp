#include "app/measuring/measures/compositing_precision.h"

#include <algorithm>
#include <cmath>

namespace echolucent {

namespace {

double roundedToHalf(double value) {
    if (value == 0.0) return 0.0;
    constexpr int significantBits = 11, leastExponent = -13;  // as std::frexp() counts: 2^-14 is the least normal
    int exponent = 0;
    (void)std::frexp(value, &exponent);
    const double spacing = std::ldexp(1.0, std::max(exponent, leastExponent) - significantBits);
    return std::nearbyint(value / spacing) * spacing;
}

double roundedToByte(double value) { return std::nearbyint(value * 255.0) / 255.0; }
double roundedToSingle(double value) { return static_cast<double>(static_cast<float>(value)); }

}  // namespace

std::string_view nameOf(CompositingPrecision precision) {
    switch (precision) {
        case CompositingPrecision::eightBit: return "8 bit";
        case CompositingPrecision::half: return "half";
        case CompositingPrecision::single: return "single";
        case CompositingPrecision::twofold: return "double";
    }
    return "";
}

Rounding roundingOf(CompositingPrecision precision) {
    switch (precision) {
        case CompositingPrecision::eightBit: return roundedToByte;
        case CompositingPrecision::half: return roundedToHalf;
        case CompositingPrecision::single: return roundedToSingle;
        case CompositingPrecision::twofold: return nullptr;
    }
    return nullptr;
}

}  // namespace echolucent
