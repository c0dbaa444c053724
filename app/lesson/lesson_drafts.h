// The drafts of lessons in the program's own folder: what a person has typed is there at the next start.
#pragma once

#include <QList>
#include <QLockFile>
#include <QString>
#include <memory>

#include "processing/lesson/lesson_draft.h"
#include "processing/result.h"
#include "widgets/lesson/lessons_panel.h"

namespace echolucent {

/// A folder for each lesson that is being written or was left. The one that is written has a lock, which says to other
/// windows whose it is: the lock of a program that has died is free.
class LessonDrafts {
public:
    /// `folder` holds the drafts' folders, and is made once there is one.
    explicit LessonDrafts(QString folder) : m_folder(std::move(folder)) {}
    ~LessonDrafts() { leave(); }
    LessonDrafts(const LessonDrafts&) = delete;
    LessonDrafts& operator=(const LessonDrafts&) = delete;

    /// The drafts that nobody writes now, newest first. Damaged ones are left out.
    [[nodiscard]] QList<LessonDraftEntry> list() const;
    /// Begins a draft of its own folder, and leaves the one before.
    void begin();
    /// Goes on with a draft of list(), and leaves the one before. Fails (unreadable) if it is damaged or written by
    /// another window.
    [[nodiscard]] Result<LessonDraft> goOn(const QString& folder);
    /// Writes the draft that was begun. Does nothing if none was.
    [[nodiscard]] Result<void> write(const LessonDraft& draft) const;
    /// Ends writing; what was written stays.
    void leave();
    /// Ends writing and removes what was written.
    void discard();

private:
    [[nodiscard]] static std::unique_ptr<QLockFile> lockOf(const QString& draft);

    QString m_folder;
    QString m_present;  ///< the folder of the draft that is being written; empty for none
    std::unique_ptr<QLockFile> m_lock;
};

}  // namespace echolucent
