#include "app/sessions/leftovers.h"

#include <QDir>
#include <QFileInfo>

#include "app/sessions/autosave.h"
#include "io/document/session_file.h"

namespace echolucent {

QString studyPathOf(const Document& document) {
    const auto* file = std::get_if<StudyFile>(&document.study);
    return file ? QString::fromStdString(file->path) : QString();
}

std::vector<Leftover> takeLeftovers(const QString& folder) {
    const QDir inside(folder);
    QStringList files;
    const QString ending = QStringLiteral(".autosave.json");
    for (const QFileInfo& info : inside.entryInfoList({'*' + ending + '*'}, QDir::Files, QDir::Time | QDir::Reversed)) {
        const QString file = inside.filePath(info.fileName().section(ending, 0, 0) + ending);
        if (!files.contains(file)) files << file;
    }
    std::vector<Leftover> leftovers;
    for (const QString& file : files) {
        Leftover found{
            file, std::make_shared<QLockFile>(Autosave::lockOf(file)), QFileInfo(file).lastModified(), {}, {}};
        // A lock can be taken only if its owner has died, however old the lock is.
        found.lock->setStaleLockTime(0);
        if (!found.lock->tryLock(0)) continue;
        // Half-written files of a program that died.
        for (const QString& half : inside.entryList({QFileInfo(file).fileName() + ".??????"}, QDir::Files))
            QFile::remove(inside.filePath(half));
        if (!QFile::exists(file)) continue;
        const auto session = readSession(file.toStdString());
        if (session) {
            found.study = studyPathOf(session->document);
        } else {
            const QString aside = file + QStringLiteral(".damaged");
            QFile::remove(aside);
            QFile::rename(file, aside);
            found.damaged = QString::fromStdString(session.error().sentence());
        }
        leftovers.push_back(std::move(found));
    }
    return leftovers;
}

}  // namespace echolucent
