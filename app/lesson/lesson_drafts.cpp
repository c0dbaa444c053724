#include "app/lesson/lesson_drafts.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QUuid>
#include <algorithm>
#include <utility>

#include "io/lesson/lesson_draft_file.h"

namespace echolucent {

std::unique_ptr<QLockFile> LessonDrafts::lockOf(const QString& draft) {
    auto lock = std::make_unique<QLockFile>(draft + QStringLiteral(".lock"));
    lock->setStaleLockTime(0);  // the lock may grow as old as the program that holds it
    return lock;
}

QList<LessonDraftEntry> LessonDrafts::list() const {
    const auto writtenAt = [](const QString& draft) {
        return QFileInfo(QDir(draft).filePath(QString::fromLatin1(lessonDraftFileName))).lastModified();
    };
    QStringList drafts;
    for (const QString& name : QDir(m_folder).entryList(QDir::Dirs | QDir::NoDotAndDotDot)) {
        const QString draft = QDir(m_folder).filePath(name);
        if (draft != m_present && writtenAt(draft).isValid()) drafts << draft;
    }
    std::ranges::sort(drafts, [&](const QString& one, const QString& other) {
        return std::pair(writtenAt(one), one) > std::pair(writtenAt(other), other);
    });
    QList<LessonDraftEntry> entries;
    for (const QString& draft : drafts) {
        if (!lockOf(draft)->tryLock(0)) continue;
        const auto read = readLessonDraft(draft.toStdString());
        if (read) entries << LessonDraftEntry{QString::fromStdString(read->lesson.texts.front().title), draft};
    }
    return entries;
}

void LessonDrafts::begin() {
    leave();
    m_present = m_folder + '/' + QString::number(QCoreApplication::applicationPid()) + '-' +
                QUuid::createUuid().toString(QUuid::Id128).left(8);
    QDir().mkpath(m_folder);
    m_lock = lockOf(m_present);
    m_lock->tryLock(0);
}

Result<LessonDraft> LessonDrafts::goOn(const QString& folder) {
    auto lock = lockOf(folder);
    if (!lock->tryLock(0))
        return fail(FailureKind::unreadable, folder.toStdString(), {}, "is being written in another window");
    auto draft = readLessonDraft(folder.toStdString());
    if (!draft) return draft;
    leave();
    m_present = folder;
    m_lock = std::move(lock);
    return draft;
}

Result<void> LessonDrafts::write(const LessonDraft& draft) const {
    if (m_present.isEmpty()) return {};
    return writeLessonDraft(m_present.toStdString(), draft);
}

void LessonDrafts::leave() {
    m_lock.reset();
    m_present.clear();
}

void LessonDrafts::discard() {
    if (!m_present.isEmpty()) QDir(m_present).removeRecursively();
    leave();
}

}  // namespace echolucent
