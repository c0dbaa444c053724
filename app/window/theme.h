// The look of the program's own controls.
#pragma once

#include <QString>

#include "widgets/theme_colours.h"

namespace echolucent {

/// Gives the application, which exists, the Fusion style with the palette and the style sheet of a theme. What is shown
/// already follows at once; where the application wears that theme already, nothing happens. Throws std::logic_error
/// where the style sheet was not built into the program, or names a colour that there is none of.
void wearTheme(Theme theme);

/// The program's style sheet with the colours of a theme in the places of their names. Throws as wearTheme().
[[nodiscard]] QString styleSheetOf(Theme theme);

}  // namespace echolucent
