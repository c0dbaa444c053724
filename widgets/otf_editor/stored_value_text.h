// Stored values as the curve editor writes them, from bytes to the largest float.
#pragma once

#include <QString>

namespace echolucent {

/// The text of a stored value. `whiteLevel`, above 0, is the stored value of intensity 1. If it is 100 to ten million,
/// and `value` at most twenty million, the text is a whole number, so that neighbouring values differ. Otherwise it has
/// three digits, and a power of ten if needed ("3.4e+38").
[[nodiscard]] QString storedValueText(double value, double whiteLevel);

}  // namespace echolucent
