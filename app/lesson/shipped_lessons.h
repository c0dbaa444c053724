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

}  // namespace echolucent
