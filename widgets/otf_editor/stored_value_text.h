// Stored values as the curve editor writes them, from bytes to the largest float.
#pragma once

#include <QString>

namespace echolucent {

/// The stored value of an intensity of 1 is `whiteLevel`, above 0. Whole numbers where it is 100 to ten million, so
/// that neighbouring values differ; else three digits and a power of ten where it needs one ("3.4e+38").
[[nodiscard]] QString storedValueText(double value, double whiteLevel);

}  // namespace echolucent
