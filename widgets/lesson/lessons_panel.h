// The panel of lessons: the list of them, or the step that is played.
#pragma once

#include <QByteArray>
#include <QList>
#include <QMap>
#include <QString>
#include <QStringList>
#include <QWidget>

class QAction;
class QLabel;
class QListWidget;
class QPushButton;
class QScrollArea;
class QStackedWidget;
class QToolButton;
class QVBoxLayout;

namespace echolucent {

class LessonEditor;
class LessonTextView;

/// A lesson in the list.
struct LessonEntry {
    QString title, summary;
    int minutes = 0;
};

/// A step as the panel shows it. Texts are Markdown.
struct LessonPage {
    QString lesson, title, text, hint, question, explanation;
    QStringList answers{};
    int number = 1, count = 1;  ///< of the step, from 1 on
    int right = 0;              ///< the right answer, counted from 0
    bool task = false;          ///< whether there is something to do
    bool done = false;          ///< whether it is done
    bool answered = false;      ///< whether the question was answered right
    QMap<QString, QByteArray> images{};
};

/// A lesson that a person has begun to write.
struct LessonDraftEntry {
    QString title, folder;
};

/// Objects: lessons (this), lessons.list, lessons.summary, lessons.begin, lessons.open, lessons.new, lessons.edit,
/// lessons.editCopy, lessons.editFolder, lessons.draft, lessons.draft.N, lessons.handout; lessons.lesson,
/// lessons.title, lessons.progress, lessons.leave, lessons.scroll, lessons.text, lessons.hint, lessons.hintText,
/// lessons.question, lessons.answer.N, lessons.verdict, lessons.explanation, lessons.done, lessons.back, lessons.next,
/// lessons.skip, lessons.reset; those of LessonEditor. No setter emits a signal.
class LessonsPanel : public QWidget {
    Q_OBJECT

public:
    explicit LessonsPanel(QWidget* parent = nullptr);

    void setLessons(const QList<LessonEntry>& lessons);
    /// Shows the list again.
    void showList();
    void showPage(const LessonPage& page);
    /// Whether the step that is shown is done.
    void setDone(bool done);

    [[nodiscard]] LessonEditor& editor() { return *m_editor; }
    void showEditor();
    /// Whether a lesson can be made of the present snapshots; if not, a sentence says why.
    void setWhyNoLesson(const QString& sentence);
    /// The lessons that can be continued, newest first.
    void setDrafts(const QList<LessonDraftEntry>& drafts);

signals:
    /// The panel is seen for the first time, and needs its list.
    void listWanted();
    void beginRequested(int lesson);
    /// A person wants a lesson from a folder of their own.
    void openRequested();
    void leaveRequested();
    void nextRequested();
    void backRequested();
    void solveRequested();
    void resetRequested();
    /// A lesson is to be made of the snapshots.
    void newRequested();
    /// A copy of a lesson of the list is to be edited.
    void editCopyRequested(int lesson);
    /// A lesson in a folder is to be edited.
    void editFolderRequested();
    void draftRequested(const QString& folder);
    void handoutRequested(int lesson);
    /// The question was answered right.
    void answeredRight();

protected:
    void showEvent(QShowEvent* event) override;

private:
    [[nodiscard]] QWidget* createList();
    [[nodiscard]] QWidget* createAuthorRows(QWidget* page);
    [[nodiscard]] QWidget* createPage();
    [[nodiscard]] QWidget* createText();
    [[nodiscard]] QWidget* createButtons();
    void showAnswers(const LessonPage& page);
    void answer(int place);
    void showEntry(int lesson);
    void showWhatIsDone();

    QList<LessonEntry> m_lessons;
    LessonPage m_page;
    bool m_asked = false;  ///< for the list
    QStackedWidget* m_pages;
    QListWidget* m_list = nullptr;
    QLabel *m_summary = nullptr, *m_lesson = nullptr, *m_title = nullptr, *m_progress = nullptr, *m_done = nullptr;
    QPushButton *m_begin = nullptr, *m_next = nullptr;
    LessonEditor* m_editor;
    QPushButton* m_new = nullptr;
    QToolButton *m_edit = nullptr, *m_draft = nullptr, *m_handout = nullptr;
    QAction* m_editCopy = nullptr;
    QToolButton *m_back = nullptr, *m_solve = nullptr, *m_reset = nullptr, *m_hint = nullptr;
    QScrollArea* m_scroll = nullptr;
    LessonTextView *m_text = nullptr, *m_hintText = nullptr, *m_question = nullptr, *m_explanation = nullptr;
    QLabel* m_verdict = nullptr;
    QWidget* m_answers = nullptr;
    QVBoxLayout* m_answerRows = nullptr;
};

}  // namespace echolucent
