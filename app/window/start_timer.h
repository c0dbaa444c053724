// Measures how long a person waits from starting the program to the first picture.
#pragma once

namespace echolucent {

class MainWindow;

/// Milliseconds since the system started this process (10 ms resolution).
[[nodiscard]] double millisecondsSinceProcessStart();

/// Prints one line each for the window, the volume, the OTF, the first (coarse) picture, every picture by its quality,
/// and the converged one. Each line has the milliseconds since the process started. Pictures before the adaptive OTF
/// are left out. Quits after the last line; with status 3 if the study cannot be opened. For
/// `echolucent FILE --first-picture`.
void printStartTimes(MainWindow& window);

}  // namespace echolucent
