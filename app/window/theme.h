// The look of the program's own controls.
#pragma once

#include <QString>

#include "widgets/theme_colours.h"

namespace echolucent {

/// Gives the application, which must exist, the Fusion style with the palette and style sheet of a theme. Visible
/// controls follow at once. Does nothing if the application has that theme already. Throws std::logic_error if the
/// style sheet was not built into the program, or names an unknown colour.
void wearTheme(Theme theme);

/// The program's style sheet, with the names of colours replaced by the theme's colours. Throws as wearTheme().
[[nodiscard]] QString styleSheetOf(Theme theme);

}  // namespace echolucent
