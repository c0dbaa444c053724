// Stored values as the curve editor writes them, from bytes to the largest float.
#pragma once

#include <QString>

namespace echolucent {

/// An intensity of 1 is stored as `whiteLevel`, above 0. If it is 100 to ten million, the text is a whole number, so
/// that neighbouring values differ. Otherwise it has three digits, and a power of ten if needed ("3.4e+38").
[[nodiscard]] QString storedValueText(double value, double whiteLevel);

}  // namespace echolucent
