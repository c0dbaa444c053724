// The file's own values as the window writes them beside normalised intensities.
#pragma once

#include <QString>

#include "processing/volume/value_scale.h"

namespace echolucent {

/// The text of a file's value in a window of values. If the window is 100 to ten million wide, and the value and its
/// ends are at most twenty million, the text is a whole number, so that neighbouring values differ. Otherwise it has
/// three digits for the width of the window, more for a window far from 0, and a power of ten if needed ("3.4e+38").
[[nodiscard]] QString valueText(double value, const ValueWindow& window);

/// The value of an intensity, in brackets after a blank: " (107)". Empty if values are normalised intensities already.
[[nodiscard]] QString valueBeside(double intensity, const ValueWindow& window);

}  // namespace echolucent
