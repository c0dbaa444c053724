// The loss if a pixel is not stored in double during compositing.
#pragma once

#include <string_view>

namespace echolucent {

/// How colour and transmittance of a pixel are stored after every sample. The computation between is in double.
enum class CompositingPrecision {
    eightBit,  ///< a frame buffer's bytes: rounded to the nearest 1/255, as graphics cards blended around 2000
    half,      ///< IEEE 754 binary16, round to nearest even
    single,    ///< binary32
    twofold,   ///< binary64
};

/// "8 bit", "half", "single", "double".
[[nodiscard]] std::string_view nameOf(CompositingPrecision precision);

/// The function that rounds a number to a precision, for PlainCasting::rounded. Null for `twofold`, which does not
/// round.
using Rounding = double (*)(double);
[[nodiscard]] Rounding roundingOf(CompositingPrecision precision);

}  // namespace echolucent
