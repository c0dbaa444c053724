// The lessons that come with the program, which are built into it.
#pragma once

#include <QStringList>
#include <string>

#include "io/lesson/lesson_file.h"

namespace echolucent {

/// The names of their folders, in the order in which they are offered.
[[nodiscard]] QStringList shippedLessons();
/// The files of one of them. Throws std::invalid_argument if there is none of the name.
[[nodiscard]] LessonFiles filesOfShipped(const QString& name);

/// Of the texts that a person is shown: that of the desktop, as textIn() takes it ("pt-br").
[[nodiscard]] std::string languageOfDesktop();

}  // namespace echolucent
