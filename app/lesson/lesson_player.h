// Plays lessons in the window: what a step shows, when it is done, and the way back to a person's own work.
#pragma once

#include <QObject>
#include <QPointer>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "app/sessions/shown_study.h"
#include "app/settings/face.h"
#include "app/study/open_study.h"
#include "processing/lesson/lesson.h"

class QMainWindow;

namespace echolucent {

class ComparePanel;
class CompareRoom;
class LessonStage;
class LessonsPanel;
class MessageBar;
class MotionPlayer;
class PaneOtfs;
class SessionKeeping;
class TubeCoreChoice;
class Works;

/// A lesson is entered and left as a session is. Entering opens the lesson's simulated scan in Teach; the person's
/// study, document, steps and session are kept, and leaving brings them back, with the face and the room that were
/// shown; if no study was open, the simulated scan of the start. If another study is opened in a lesson, the lesson
/// ends there. That study takes over look, curves and method of the person's own document, and what was changed and not
/// saved before the lesson is left unsaved. What a step sets is one step of the history.
///
///            enter()               the scan is made                leave(), or after the last step
///   [none] ----------> [entering] ------------------> [playing] ----------------------------------> [none]
class LessonPlayer : public QObject {
    Q_OBJECT

public:
    struct Parts {
        QMainWindow& window;
        DocumentModel& model;
        OpenStudy& openStudy;
        Works& works;
        PaneOtfs& otfs;
        TubeCoreChoice& tubeCore;
        MotionPlayer& player;
        CompareRoom& compare;
        const ComparePanel& measured;
        ShownStudy& shown;
        SessionKeeping& sessions;
        LessonsPanel& panel;
        LessonStage& stage;
        MessageBar& messages;
        std::function<Face()> face;
        std::function<void(Face)> chooseFace;
    };
    /// What the parts refer to must outlive this object.
    explicit LessonPlayer(const Parts& parts, QObject* parent = nullptr);

    /// The lessons that come with the program; read when they are asked for first.
    [[nodiscard]] const std::vector<Lesson>& lessons();
    /// Begins a lesson, which must hold its rules, with one of its steps. Leaves one that is played. Says in a message
    /// if a session is just being saved, and then does nothing.
    void enter(const Lesson& lesson, std::size_t first = 0);
    /// Begins the lesson in a folder, or says in a message why not.
    void enterFolder(const QString& folder);
    /// Ends the lesson and brings the person's own work back. Does nothing if none is played. If a study is being
    /// loaded, it wins: the lesson ends once it is there, or once it will not come.
    void leave();
    /// leave() at once, whatever is being loaded.
    void leaveNow();
    /// Whether a lesson is played; false while its scan is being made.
    [[nodiscard]] bool playing() const { return m_lesson.has_value(); }
    /// The lesson that is played; none while its scan is being made.
    [[nodiscard]] const std::optional<Lesson>& lesson() const { return m_lesson; }
    /// The step that is shown, counted from 0.
    [[nodiscard]] std::size_t step() const { return m_step; }
    /// Whether the present step's condition has held since the step began, or it has none.
    [[nodiscard]] bool isDone() const;

    /// Goes on. A step whose task is not done is solved first: what follows begins with what it makes.
    void next();
    void back();
    /// Solves the step by its document, or by the choice of the tube core that it asks for. The step stays, so that a
    /// class sees what was done.
    void solve();
    /// Sets the document as it was when the step began.
    void reset();
    /// Makes a document of the study that is open the present one, as one step of this name, in the room that shows it.
    void show(const Document& document, const QString& step);

    /// What the window has measured under a name of lessonMeasures(); none if it is not known now.
    [[nodiscard]] std::optional<DocumentValue> measured(std::string_view name) const;

signals:
    /// Panels are about to be moved, because a lesson begins or ends.
    void aboutToArrange();
    /// A lesson has begun or ended.
    void playingChanged(bool playing);
    /// Another step is shown.
    void stepChanged(std::size_t step);

private:
    /// What was open before the lesson.
    struct Before {
        std::shared_ptr<const OpenStudy::Kept> study;
        ShownStudy::Kept document;
        Face face = Face::review;
        bool compares = false;
    };
    struct Progress {
        std::optional<Document> began;  ///< the document with which the step began, once it did
        bool done = false, answered = false;
    };
    void connectPanel();
    void chooseFolder();
    void keepBefore();
    void begin();
    void end();
    void showOfStep(const Document& document);
    void goTo(std::size_t step, const std::optional<Document>& document);
    void showPage();
    void chooseTubeCore();
    void look();

    Parts m_parts;
    std::optional<std::vector<Lesson>> m_lessons;
    std::optional<Lesson> m_entering;  ///< while its scan is being made
    std::size_t m_first = 0;           ///< the step with which it begins
    bool m_asking = false;             ///< while this object asks for a study
    bool m_arriving = false;           ///< while the study of m_entering replaces the present one
    std::optional<Lesson> m_lesson;
    bool m_leaving = false;          ///< once the study that is being loaded will not come
    std::optional<Before> m_before;  ///< while the lesson's document is shown, or that of a lesson that has ended
    std::size_t m_step = 0;
    std::vector<Progress> m_progress;
};

}  // namespace echolucent
