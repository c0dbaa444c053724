#include "widgets/lesson/lesson_step_editor.h"

#include <QComboBox>
#include <QCompleter>
#include <QDockWidget>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QScopedValueRollback>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

#include "widgets/controls/dock_around.h"
#include "widgets/controls/panel_controls.h"
#include "widgets/lesson/lesson_question_editor.h"

namespace echolucent {

namespace {

QToolButton* stepButton(const QString& text, const QString& name, const QString& tip, QWidget* parent) {
    auto* button = named(new QToolButton(parent), "lessons.editor.step." + name, text, tip);
    button->setText(text);
    return button;
}

QHBoxLayout* lineIn(QWidget* box) {
    auto* line = new QHBoxLayout(box);
    line->setContentsMargins(0, 0, 0, 0);
    return line;
}

}  // namespace

QLabel* problemLabel(const QString& name, QWidget* parent) {
    auto* label = named(new QLabel(parent), name, LessonStepEditor::tr("What is wrong"));
    label->setWordWrap(true);
    label->setTextFormat(Qt::PlainText);
    label->hide();
    return label;
}

void showProblem(QLabel& label, const QString& sentence) {
    label.setText(sentence.isEmpty() ? QString() : QStringLiteral("⚠ ") + sentence);
    label.setVisible(!sentence.isEmpty());
}

LessonStepEditor::LessonStepEditor(QWidget* parent)
    : QWidget(parent),
      m_text(wordsEdit("lessons.editor.step.text", tr("Text of the step"), tr("What is to be seen and done (Markdown)"),
                       6, this)),
      m_hint(wordsEdit("lessons.editor.step.hint", tr("Hint"), tr("How it is done; empty for none"), 2, this)),
      m_title(named(new QLineEdit(this), "lessons.editor.step.title", tr("Title of the step"))),
      m_condition(new LessonConditionEditor(this)),
      m_question(new LessonQuestionEditor(this)),
      m_column(new QVBoxLayout(this)) {
    setObjectName("lessons.editor.step");
    setAccessibleName(tr("The chosen step"));
    m_column->setContentsMargins(0, 0, 0, 0);
    addField(tr("Title of the step"), m_title, LessonField::stepTitle);
    addField(tr("Text"), m_text, LessonField::text);
    m_column->addWidget(createView());
    addField(tr("What to look at"), createTarget(), LessonField::target);
    addField(tr("The step is done once"), m_condition, LessonField::condition);
    m_column->addWidget(createSolution());
    addField(tr("Hint"), m_hint, LessonField::hint);
    addField(tr("Question"), m_question, LessonField::question);
    addProblem(LessonField::explanation);
    const auto tell = [this] {
        if (!m_showing) emit edited();
    };
    connect(m_title, &QLineEdit::textEdited, this, tell);
    connect(m_text, &QPlainTextEdit::textChanged, this, tell);
    connect(m_hint, &QPlainTextEdit::textChanged, this, tell);
    connect(m_target, &QComboBox::editTextChanged, this, tell);
    connect(m_condition, &LessonConditionEditor::edited, this, tell);
    connect(m_question, &LessonQuestionEditor::edited, this, tell);
    connect(m_question, &LessonQuestionEditor::addRequested, this, &LessonStepEditor::answerAddRequested);
    connect(m_question, &LessonQuestionEditor::removeRequested, this, &LessonStepEditor::answerRemoveRequested);
}

void LessonStepEditor::addField(const QString& label, QWidget* field, LessonField problem) {
    m_column->addWidget(labelFor(field, label));
    m_column->addWidget(field);
    addProblem(problem);
}

void LessonStepEditor::addProblem(LessonField field) {
    m_problems[field] =
        problemLabel(QStringLiteral("lessons.editor.step.problem.%1").arg(static_cast<int>(field)), this);
    m_column->addWidget(m_problems[field]);
}

QWidget* LessonStepEditor::createView() {
    auto* box = new QWidget(this);
    auto* column = new QVBoxLayout(box);
    column->setContentsMargins(0, 0, 0, 0);
    m_view = secondaryLabel();
    named(m_view, "lessons.editor.step.view", tr("What the step sets"));
    m_view->setWordWrap(true);
    auto* buttons = new QWidget(box);
    auto* line = lineIn(buttons);
    m_take =
        stepButton(tr("Take this view"), "take", tr("The step sets everything as the window shows it now"), buttons);
    m_goOn = stepButton(tr("Set nothing"), "goOn", tr("The step goes on from the one before"), buttons);
    auto* show = stepButton(tr("Show it"), "show", tr("Shows in the window what the step begins with"), buttons);
    for (QToolButton* button : {m_take, m_goOn, show}) line->addWidget(button);
    line->addStretch(1);
    column->addWidget(m_view);
    column->addWidget(buttons);
    connect(m_take, &QToolButton::clicked, this, &LessonStepEditor::takeViewRequested);
    connect(m_goOn, &QToolButton::clicked, this, &LessonStepEditor::goOnRequested);
    connect(show, &QToolButton::clicked, this, &LessonStepEditor::showRequested);
    return box;
}

QWidget* LessonStepEditor::createTarget() {
    auto* box = new QWidget(this);
    auto* column = new QVBoxLayout(box);
    column->setContentsMargins(0, 0, 0, 0);
    m_target = named(new QComboBox(box), "lessons.editor.step.target", tr("What to look at"),
                     tr("This control is outlined in the window. Choose it, type its name, or point at it"));
    m_target->setEditable(true);
    m_target->setInsertPolicy(QComboBox::NoInsert);
    m_target->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_target->setMinimumContentsLength(12);
    m_target->completer()->setFilterMode(Qt::MatchContains);
    m_target->completer()->setCompletionMode(QCompleter::PopupCompletion);
    m_target->lineEdit()->setPlaceholderText(tr("nothing"));
    wheelNeedsFocus(m_target);
    m_point = stepButton(tr("Point at it in the window"), "point",
                         tr("The next click in the window names a control. Escape ends it"), box);
    m_point->setCheckable(true);
    column->addWidget(m_target);
    column->addWidget(m_point, 0, Qt::AlignLeft);
    // An entry is chosen by its words, and the field holds its name.
    connect(m_target, &QComboBox::activated, this,
            [this](int entry) { m_target->setEditText(m_target->itemData(entry).toString()); });
    connect(m_point, &QToolButton::clicked, this,
            [this](bool on) { on&& m_window != nullptr ? m_pointing.begin(*m_window) : m_pointing.end(); });
    connect(&m_pointing, &TargetPointing::pointed, this,
            [this](const QString& name) { m_point->setText(name.isEmpty() ? tr("Click a control") : name); });
    connect(&m_pointing, &TargetPointing::chosen, m_target, &QComboBox::setEditText);
    connect(&m_pointing, &TargetPointing::ended, this, [this] {
        m_point->setChecked(false);
        m_point->setText(m_point->accessibleName());
        if (QDockWidget* dock = dockAround(this)) dock->raise();  // the control may be on another panel
    });
    return box;
}

QWidget* LessonStepEditor::createSolution() {
    auto* box = new QWidget(this);
    auto* column = new QVBoxLayout(box);
    column->setContentsMargins(0, 0, 0, 0);
    m_solution = secondaryLabel();
    named(m_solution, "lessons.editor.step.solution", tr("The view that solves the step"));
    m_solution->setWordWrap(true);
    auto* buttons = new QWidget(box);
    auto* line = lineIn(buttons);
    m_solve = stepButton(tr("Take this view as solved"), "solve", tr("\"Do it for me\" shows this view"), buttons);
    m_unsolve = stepButton(tr("No solution"), "unsolve", tr("\"Do it for me\" shows nothing"), buttons);
    line->addWidget(m_solve);
    line->addWidget(m_unsolve);
    line->addStretch(1);
    column->addWidget(m_solution);
    column->addWidget(buttons);
    connect(m_solve, &QToolButton::clicked, this, &LessonStepEditor::solveRequested);
    connect(m_unsolve, &QToolButton::clicked, this, &LessonStepEditor::unsolveRequested);
    return box;
}

void LessonStepEditor::setStep(const LessonStep& step, const LessonStepText& words) {
    const QScopedValueRollback showing(m_showing, true);
    const QString title = QString::fromStdString(words.title), target = QString::fromStdString(step.lookAt);
    if (m_title->text() != title) m_title->setText(title);
    setWords(*m_text, words.text);
    setWords(*m_hint, words.hint);
    if (m_target->currentText() != target) m_target->setEditText(target);
    m_condition->setCondition(step.until);
    m_question->setQuestion(words, step.right);
    m_view->setText(step.set ? tr("The step begins with a view of its own.")
                             : tr("The step goes on from the one before."));
    enableOrSayWhy(*m_goOn, step.set.has_value(), tr("It sets nothing already."));
    m_isSolved = step.solved.has_value();
    m_unsolve->setEnabled(m_isSolved);
    setSolutionSentence({});
}

void LessonStepEditor::takeInto(LessonStep& step, LessonStepText& words) const {
    words.title = m_title->text().toStdString();
    words.text = m_text->toPlainText().toStdString();
    words.hint = m_hint->toPlainText().toStdString();
    m_question->takeInto(words);
    step.right = m_question->right();
    step.lookAt = m_target->currentText().trimmed().toStdString();
    step.until = m_condition->condition();
}

void LessonStepEditor::setProblems(const QList<LessonProblem>& problems) {
    for (const auto& [field, label] : m_problems.asKeyValueRange()) {
        const auto found = std::ranges::find(problems, field, &LessonProblem::field);
        showProblem(*label, found == problems.end() ? QString() : QString::fromStdString(found->sentence));
    }
}

void LessonStepEditor::setSolutionSentence(const QString& sentence) {
    const QString own = m_isSolved ? tr("A view solves the step.") : tr("No view solves the step.");
    m_solution->setText(sentence.isEmpty() ? own : own + QLatin1Char(' ') + sentence);
}

void LessonStepEditor::setTargets(const QList<LessonTarget>& targets) {
    const QScopedValueRollback showing(m_showing, true);
    const QString typed = m_target->currentText();
    m_target->clear();
    for (const LessonTarget& target : targets)
        m_target->addItem(QStringLiteral("%1  %2").arg(target.words, target.name), target.name);
    m_target->setCurrentIndex(-1);
    m_target->setEditText(typed);
}

void LessonStepEditor::setViewIsOfLesson(bool isOfLesson) {
    const QString whyNot = tr("The lesson's scan is not open. \"Show it\" opens it.");
    enableOrSayWhy(*m_take, isOfLesson, whyNot);
    enableOrSayWhy(*m_solve, isOfLesson, whyNot);
}

}  // namespace echolucent
