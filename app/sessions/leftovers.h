// What earlier runs of the program left of sessions that nobody saved.
#pragma once

#include <QDateTime>
#include <QLockFile>
#include <QString>
#include <memory>
#include <vector>

#include "processing/document/document.h"

namespace echolucent {

/// A file of another run; whoever holds its lock has it to himself.
struct Leftover {
    QString file;
    std::shared_ptr<QLockFile> lock;
    QDateTime time;   ///< when it was written last
    QString study;    ///< path of the study's file or folder; empty of a simulated scan
    QString damaged;  ///< why it cannot be opened, as a sentence; it was put aside. Empty where it can.
};

/// The files in a folder that no living program holds, oldest first, each with its lock. One that cannot be read is
/// renamed to end in ".damaged", so that it is told once.
[[nodiscard]] std::vector<Leftover> takeLeftovers(const QString& folder);

/// The path of a session's study; empty of a simulated scan.
[[nodiscard]] QString studyPathOf(const Document& document);

}  // namespace echolucent
