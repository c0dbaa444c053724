// What is opened and written by actions by chance.
#pragma once

#include <QString>
#include <QStringList>

namespace echolucent {

struct StressFiles {
    QStringList studies;   ///< that can be opened
    QStringList failures;  ///< that are missing or broken
    QString folder;        ///< for sessions, pictures and pages that are saved
};

}  // namespace echolucent
