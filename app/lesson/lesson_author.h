// Lets a person write lessons in the window: made of snapshots or of other lessons, kept while they are written, saved.
#pragma once

#include <QObject>
#include <QTimer>
#include <optional>

#include "app/lesson/lesson_drafts.h"
#include "processing/lesson/lesson_draft.h"

class QMainWindow;

namespace echolucent {

class CompareRoom;
class DocumentModel;
class LessonHandouts;
class LessonPlayer;
class LessonsPanel;
class MessageBar;
class OpenStudy;
class Settings;
class Snapshots;
class StudyNames;

/// A lesson that is written is kept as a draft in the program's own folder: soon after each change, and at the end. A
/// lesson that was closed and not saved is offered again, also by the next start. Views are taken from the window while
/// it shows the lesson's simulated scan; another study is never closed for that, but by a person's wish to see a step.
///
///            beginNew(), editCopy(), ...              close()            continueDraft()
///   [none] ------------------------------> [writing] --------> [a draft] ----------------> [writing]
///                                              |  saved, or unchanged: no draft is left
class LessonAuthor : public QObject {
    Q_OBJECT

public:
    struct Parts {
        QMainWindow& window;
        DocumentModel& model;
        OpenStudy& openStudy;
        Snapshots& snapshots;
        CompareRoom& compare;
        LessonPlayer& player;
        LessonHandouts& handouts;
        LessonsPanel& panel;
        Settings& settings;
        MessageBar& messages;
        StudyNames& names;
    };
    /// What the parts refer to must outlive this object.
    explicit LessonAuthor(const Parts& parts, QObject* parent = nullptr);
    /// Keeps what is being written.
    ~LessonAuthor() override;

    /// The lesson that is being written; none if none is.
    [[nodiscard]] const std::optional<LessonDraft>& draft() const { return m_draft; }
    /// Makes a lesson of the snapshots. Does nothing if whyNoLesson() says why not.
    void beginNew();
    /// Writes on a copy of a lesson.
    void editCopy(const Lesson& lesson);
    /// Writes on the lesson in a folder, or says in a message why not.
    void editFolder(const QString& folder);
    /// Writes on a draft, or says in a message why not.
    void continueDraft(const QString& folder);
    /// Saves the lesson, which must have no problems, into a folder: one that is new or empty, or the one in which it
    /// was saved before. Says in a message how that ended.
    void saveTo(const QString& folder);
    /// Shows the list of lessons again. What was not saved is kept.
    void close();
    /// Throws the lesson away that is being written. A message offers to bring it back.
    void discard();
    /// Writes the draft now if it has changed.
    void keep();

private:
    void connectEditor();
    void showDraft(const LessonDraft& draft, const std::optional<Lesson>& elsewhere);
    void end();
    void edit(const std::function<void(Lesson& lesson, std::size_t& step)>& change);
    void takeEdited();
    void check();
    void showNames();
    void showSolution();
    void followStudy();
    void chooseAndSave();
    void show();
    void play();
    [[nodiscard]] bool isUnsaved() const;
    [[nodiscard]] bool scanIsOpen() const;
    [[nodiscard]] Document presentView() const;

    Parts m_parts;
    LessonDrafts m_drafts;
    std::optional<LessonDraft> m_draft;
    std::optional<Lesson> m_elsewhere;  ///< a lesson from which a draft that does not differ is not kept
    QTimer m_keeping;                   ///< runs from a change until it is kept
};

}  // namespace echolucent
