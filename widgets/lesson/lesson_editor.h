// A lesson while a person writes it, as a page of the panel of lessons.
#pragma once

#include <QWidget>
#include <vector>

#include "processing/lesson/lesson_draft.h"

class QComboBox;
class QLabel;
class QLineEdit;
class QListWidget;
class QPlainTextEdit;
class QPushButton;
class QSpinBox;
class QToolButton;

namespace echolucent {

class LessonStepEditor;

/// Objects: lessons.editor (this); lessons.editor.title, .summary, .minutes, .language, .steps, .add, .remove, .up,
/// .down, .problem.title, .problem.summary, .problem, .play, .save, .handout, .discard, .close, .scroll; those of
/// LessonStepEditor. No setter emits a signal.
class LessonEditor : public QWidget {
    Q_OBJECT

public:
    explicit LessonEditor(QWidget* parent = nullptr);

    /// Shows a draft. It must have texts.
    void setDraft(const LessonDraft& draft);
    /// The draft as it is now, with all that was typed.
    [[nodiscard]] const LessonDraft& draft() const { return m_draft; }
    /// What is wrong with the draft: shown at its fields, and until there is nothing it is neither played nor saved.
    void setProblems(const std::vector<LessonProblem>& problems);
    /// Whether the present view is one of the lesson's scan.
    void setViewIsOfLesson(bool isOfLesson);
    [[nodiscard]] LessonStepEditor& stepEditor() { return *m_step; }

signals:
    /// The draft has changed: a text, a choice, or the step that is edited.
    void edited();
    /// A person adds a step with the present view behind the chosen one.
    void addRequested();
    void takeViewRequested();
    void showRequested();
    void solveRequested();
    void playRequested();
    void saveRequested();
    void handoutRequested();
    void discardRequested();
    void closeRequested();

private:
    [[nodiscard]] QWidget* createHead();
    [[nodiscard]] QWidget* createSteps();
    [[nodiscard]] QWidget* createFoot();
    void connectStep();
    void take();
    void change(const std::function<void(Lesson& lesson, std::size_t& step)>& change);
    void showAll();
    void showSteps();
    void showStep();
    void showStepProblems();
    [[nodiscard]] bool hasStep() const { return m_draft.step < m_draft.lesson.steps.size(); }
    [[nodiscard]] LessonText& text() { return m_draft.lesson.texts.at(m_draft.language); }

    LessonDraft m_draft;
    std::vector<LessonProblem> m_problems;
    QLineEdit* m_title = nullptr;
    QPlainTextEdit* m_summary = nullptr;
    QSpinBox* m_minutes = nullptr;
    QComboBox* m_language = nullptr;
    QListWidget* m_steps = nullptr;
    QToolButton *m_add = nullptr, *m_remove = nullptr, *m_up = nullptr, *m_down = nullptr, *m_handout = nullptr;
    QPushButton *m_play = nullptr, *m_save = nullptr;
    QLabel *m_titleProblem = nullptr, *m_summaryProblem = nullptr, *m_problem = nullptr;
    LessonStepEditor* m_step = nullptr;
    bool m_showing = false;
};

}  // namespace echolucent
