// What the window's program does before there is a window.
#pragma once

#include <QApplication>
#include <memory>

namespace echolucent {

/// Whether the words of the command line ask for the help or the version, for which no display is needed.
[[nodiscard]] bool asksForWordsOnly(int count, char** arguments);

/// Makes the application. If no display can be opened, ends the program with one sentence on standard error and exit
/// status 1; Qt alone would abort it.
[[nodiscard]] std::unique_ptr<QApplication> applicationOnDisplay(int& count, char** arguments);

/// From here on, numbers are written with a point and in digits from 0 to 9, by Qt and by the C library, whatever the
/// desktop says. Call it after the application was made, which takes over what the desktop says.
void writeNumbersAlike();

}  // namespace echolucent
