// The file's own values: how they come from the voxels in memory, and which of them are black and white.
#pragma once

#include <cmath>

namespace echolucent {

/// In memory, black is 0. A volume whose file puts black elsewhere, or holds values that float32 cannot, keeps
/// (file's value - black) / factor, and gives back the file's value by this line. Here and in Volume, the *stored*
/// value is that in memory.
struct ValueScale {
    double black = 0.0;   ///< the file's value of a stored 0, shown as normalised intensity 0; finite
    double factor = 1.0;  ///< how much a stored 1 is in the file; a power of two. It is 1 unless float32 is too small

    [[nodiscard]] bool isIdentity() const { return black == 0.0 && factor == 1.0; }
    /// The file's value of a stored one. No sum on the way overflows. It is 0 if it lies within the rounding of stored
    /// float32 beside 0.
    [[nodiscard]] double fileValue(double stored) const {
        constexpr double rounding = 1e-7;
        const double value = std::fma(factor, stored, black);
        return std::abs(value) < rounding * std::abs(black) ? 0.0 : value;
    }
    /// The stored value of a file's one, before it is rounded to the type of the voxels.
    [[nodiscard]] double storedValue(double value) const { return value / factor - black / factor; }
    friend bool operator==(const ValueScale&, const ValueScale&) = default;
};

/// The file's values between which pictures, curves and histograms are made: normalised intensities 0 and 1.
struct ValueWindow {
    double black = 0.0;
    double white = 1.0;  ///< above `black`

    /// Whether values are normalised intensities already.
    [[nodiscard]] bool isNormalised() const { return black == 0.0 && white == 1.0; }
    [[nodiscard]] double valueAt(double intensity) const { return std::lerp(black, white, intensity); }
    [[nodiscard]] double intensityOf(double value) const {
        // Halves, because the range of doubles may be larger than the largest of them.
        return black == 0.0 ? value / white : (value / 2 - black / 2) / (white / 2 - black / 2);
    }
    friend bool operator==(const ValueWindow&, const ValueWindow&) = default;
};

/// Whether a scale has numbers that a reader gives: a finite black, and a finite factor above 0.
[[nodiscard]] inline bool isSensible(const ValueScale& scale) {
    return std::isfinite(scale.black) && std::isfinite(scale.factor) && scale.factor > 0.0;
}

}  // namespace echolucent
