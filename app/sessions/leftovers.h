// What earlier runs of the program left of sessions that nobody saved.
#pragma once

#include <QDateTime>
#include <QLockFile>
#include <QString>
#include <memory>
#include <vector>

#include "processing/document/document.h"

namespace echolucent {

/// A file of another run. Whoever holds its lock has it alone.
struct Leftover {
    QString file;
    std::shared_ptr<QLockFile> lock;
    QDateTime time;   ///< when it was written last
    QString study;    ///< path of the study's file or folder; empty for a simulated scan
    QString damaged;  ///< a sentence: why it cannot be opened and was put aside; empty if it can be opened
};

/// The files in a folder that no living program holds, oldest first, each with its lock. Removes what died programs
/// left half written. Renames an unreadable file to end in ".damaged", so that it is told of once.
[[nodiscard]] std::vector<Leftover> takeLeftovers(const QString& folder);

/// The path of a session's study; empty for a simulated scan and for no study.
[[nodiscard]] QString studyPathOf(const Document& document);

}  // namespace echolucent
