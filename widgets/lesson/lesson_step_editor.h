// One step of a lesson while it is written: words, what to look at, what it sets, when it is done, its question.
#pragma once

#include <QMap>
#include <QWidget>

#include "processing/lesson/lesson_draft.h"
#include "widgets/lesson/lesson_condition_editor.h"
#include "widgets/lesson/target_pointing.h"

class QComboBox;
class QLabel;
class QLineEdit;
class QPlainTextEdit;
class QToolButton;
class QVBoxLayout;

namespace echolucent {

class LessonQuestionEditor;

/// A label for a sentence on what is wrong; hidden without one.
[[nodiscard]] QLabel* problemLabel(const QString& name, QWidget* parent);
void showProblem(QLabel& label, const QString& sentence);

/// Objects: lessons.editor.step (this); lessons.editor.step.title, .text, .hint, .target, .point, .take, .goOn, .show,
/// .view, .solve, .unsolve, .solution; a field's problem: .problem.N with the number of its LessonField; those of
/// LessonConditionEditor and LessonQuestionEditor. No setter emits a signal.
class LessonStepEditor : public QWidget {
    Q_OBJECT

public:
    explicit LessonStepEditor(QWidget* parent = nullptr);

    void setStep(const LessonStep& step, const LessonStepText& words);
    /// Takes what was typed; what the step sets and its solution stay.
    void takeInto(LessonStep& step, LessonStepText& words) const;
    /// What is wrong with this step in this language.
    void setProblems(const QList<LessonProblem>& problems);
    /// Whether the solution makes the condition hold, as a sentence; empty if that is not known.
    void setSolutionSentence(const QString& sentence);
    void setTargets(const QList<LessonTarget>& targets);
    void setNames(const QStringList& names) { m_condition->setNames(names); }
    void setPresentValue(NamedValue value) { m_condition->setPresentValue(std::move(value)); }
    /// Whether the present view is one of the lesson's scan.
    void setViewIsOfLesson(bool isOfLesson);
    /// The window in which a person points at a control.
    void setWindow(QWidget& window) { m_window = &window; }

signals:
    void edited();
    void takeViewRequested();
    /// The step is to go on from the one before.
    void goOnRequested();
    void showRequested();
    void solveRequested();
    void unsolveRequested();
    void answerAddRequested();
    void answerRemoveRequested(int answer);

private:
    void addField(const QString& label, QWidget* field, LessonField problem);
    void addProblem(LessonField field);
    [[nodiscard]] QWidget* createTarget();
    [[nodiscard]] QWidget* createView();
    [[nodiscard]] QWidget* createSolution();

    QPlainTextEdit *m_text, *m_hint;
    QLineEdit* m_title;
    QComboBox* m_target = nullptr;
    QToolButton *m_point = nullptr, *m_take = nullptr, *m_goOn = nullptr, *m_solve = nullptr, *m_unsolve = nullptr;
    QLabel *m_view = nullptr, *m_solution = nullptr;
    LessonConditionEditor* m_condition;
    LessonQuestionEditor* m_question;
    QMap<LessonField, QLabel*> m_problems;
    QVBoxLayout* m_column;
    TargetPointing m_pointing;
    QWidget* m_window = nullptr;
    QString m_solutionSentence;
    bool m_isSolved = false, m_showing = false;
};

}  // namespace echolucent
