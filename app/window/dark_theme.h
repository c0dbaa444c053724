// The look of the program's own controls.
#pragma once

namespace echolucent {

/// Gives the application, which exists, the Fusion style and the dark style sheet. Throws std::logic_error where the
/// style sheet was not built into the program.
void wearDarkTheme();

}  // namespace echolucent
