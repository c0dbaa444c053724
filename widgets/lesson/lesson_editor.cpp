#include "widgets/lesson/lesson_editor.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QScopedValueRollback>
#include <QScrollArea>
#include <QSpinBox>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

#include "widgets/controls/number_box.h"
#include "widgets/controls/panel_controls.h"
#include "widgets/lesson/lesson_question_editor.h"
#include "widgets/lesson/lesson_step_editor.h"

namespace echolucent {

namespace {

constexpr int mostMinutes = 600;

QToolButton* editorButton(const QString& text, const QString& name, const QString& tip, QWidget* parent) {
    auto* button = named(new QToolButton(parent), "lessons.editor." + name, text, tip);
    button->setText(text);
    return button;
}

}  // namespace

LessonEditor::LessonEditor(QWidget* parent) : QWidget(parent) {
    setObjectName("lessons.editor");
    setAccessibleName(tr("Editor of a lesson"));
    auto* scroll = new QScrollArea(this);
    scroll->setObjectName("lessons.editor.scroll");
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setWidgetResizable(true);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setFocusPolicy(Qt::NoFocus);
    auto* content = new QWidget(scroll);
    auto* fields = new QVBoxLayout(content);
    fields->setContentsMargins(0, 0, 4, 0);
    m_step = new LessonStepEditor(content);
    fields->addWidget(createHead());
    fields->addWidget(createSteps());
    fields->addWidget(m_step);
    fields->addStretch(1);
    scroll->setWidget(content);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(scroll, 1);
    column->addWidget(createFoot());
    connectStep();
}

QWidget* LessonEditor::createHead() {
    auto* head = new QWidget(this);
    auto* column = new QVBoxLayout(head);
    column->setContentsMargins(0, 0, 0, 0);
    m_title = named(new QLineEdit(head), "lessons.editor.title", tr("Title of the lesson"));
    m_title->setPlaceholderText(tr("Title of the lesson"));
    m_titleProblem = problemLabel("lessons.editor.problem.title", head);
    m_summary = wordsEdit("lessons.editor.summary", tr("What the lesson is about"),
                          tr("One or two sentences on what it shows"), 2, head);
    m_summaryProblem = problemLabel("lessons.editor.problem.summary", head);
    m_minutes = named(new WholeNumberBox(head), "lessons.editor.minutes", tr("Minutes that it takes"));
    m_minutes->setRange(1, mostMinutes);
    m_minutes->setSuffix(tr(" minutes"));
    wheelNeedsFocus(m_minutes);
    m_language = named(new QComboBox(head), "lessons.editor.language", tr("Language of the texts"),
                       tr("The texts of this language are edited"));
    wheelNeedsFocus(m_language);
    auto* line = new QHBoxLayout;
    line->addWidget(m_minutes);
    line->addWidget(m_language);
    line->addStretch(1);
    column->addWidget(m_title);
    column->addWidget(m_titleProblem);
    column->addWidget(m_summary);
    column->addWidget(m_summaryProblem);
    column->addLayout(line);
    connect(m_title, &QLineEdit::textEdited, this, &LessonEditor::take);
    connect(m_summary, &QPlainTextEdit::textChanged, this, &LessonEditor::take);
    connect(m_minutes, &QSpinBox::valueChanged, this, &LessonEditor::take);
    connect(m_language, &QComboBox::activated, this, [this](int language) {
        m_draft.language = static_cast<std::size_t>(language);
        showAll();
        emit edited();
    });
    return head;
}

QWidget* LessonEditor::createSteps() {
    auto* box = new QWidget(this);
    auto* column = new QVBoxLayout(box);
    column->setContentsMargins(0, 0, 0, 0);
    m_steps = named(new QListWidget(box), "lessons.editor.steps", tr("Steps"));
    constexpr int height = 110;  // pixels
    m_steps->setFixedHeight(height);
    auto* line = new QHBoxLayout;
    m_add = editorButton(tr("Add"), "add", tr("Adds a step with the present view behind the chosen one"), box);
    m_remove = editorButton(tr("Remove"), "remove", tr("Removes the chosen step"), box);
    m_up = editorButton(tr("Up"), "up", tr("Moves the chosen step up"), box);
    m_down = editorButton(tr("Down"), "down", tr("Moves the chosen step down"), box);
    for (QToolButton* button : {m_add, m_remove, m_up, m_down}) line->addWidget(button);
    line->addStretch(1);
    column->addWidget(labelFor(m_steps, tr("Steps")));
    column->addWidget(m_steps);
    column->addLayout(line);
    connect(m_add, &QToolButton::clicked, this, &LessonEditor::addRequested);
    connect(m_remove, &QToolButton::clicked, this, [this] {
        change([](Lesson& lesson, std::size_t& step) {
            removeStep(lesson, step);
            if (step > 0 && step == lesson.steps.size()) --step;
        });
    });
    connect(m_up, &QToolButton::clicked, this, [this] {
        change([](Lesson& lesson, std::size_t& step) {
            moveStep(lesson, step, step - 1);
            --step;
        });
    });
    connect(m_down, &QToolButton::clicked, this, [this] {
        change([](Lesson& lesson, std::size_t& step) {
            moveStep(lesson, step, step + 1);
            ++step;
        });
    });
    connect(m_steps, &QListWidget::currentRowChanged, this, [this](int row) {
        if (m_showing || row < 0) return;
        m_draft.step = static_cast<std::size_t>(row);
        showStep();
        emit edited();
    });
    // A click beside the steps would choose none.
    connect(m_steps, &QListWidget::itemSelectionChanged, this, [this] {
        if (m_steps->currentItem() != nullptr) m_steps->currentItem()->setSelected(true);
    });
    return box;
}

QWidget* LessonEditor::createFoot() {
    auto* foot = new QWidget(this);
    auto* column = new QVBoxLayout(foot);
    column->setContentsMargins(0, 0, 0, 0);
    m_problem = problemLabel("lessons.editor.problem", foot);
    m_play = named(new QPushButton(tr("Play"), foot), "lessons.editor.play", tr("Play the lesson"),
                   tr("Plays the lesson from the chosen step. Leaving it brings this page back"));
    m_save = named(new QPushButton(tr("Save lesson…"), foot), "lessons.editor.save", tr("Save the lesson"),
                   tr("Writes the lesson into a folder"));
    auto* close = editorButton(tr("Close"), "close",
                               tr("Shows the list of lessons. What was not saved is kept as a draft"), foot);
    m_handout = editorButton(tr("Save handout…"), "handout",
                             tr("Writes the lesson as a page that opens without a network"), foot);
    auto* discard = editorButton(tr("Discard"), "discard", tr("Throws away what was not saved"), foot);
    auto* first = new QHBoxLayout;
    first->addWidget(m_play);
    first->addWidget(m_save);
    first->addStretch(1);
    first->addWidget(close);
    auto* second = new QHBoxLayout;
    second->addWidget(m_handout);
    second->addStretch(1);
    second->addWidget(discard);
    column->addWidget(m_problem);
    column->addLayout(first);
    column->addLayout(second);
    connect(m_play, &QPushButton::clicked, this, &LessonEditor::playRequested);
    connect(m_save, &QPushButton::clicked, this, &LessonEditor::saveRequested);
    connect(m_handout, &QToolButton::clicked, this, &LessonEditor::handoutRequested);
    connect(discard, &QToolButton::clicked, this, &LessonEditor::discardRequested);
    connect(close, &QToolButton::clicked, this, &LessonEditor::closeRequested);
    return foot;
}

void LessonEditor::connectStep() {
    connect(m_step, &LessonStepEditor::edited, this, &LessonEditor::take);
    connect(m_step, &LessonStepEditor::takeViewRequested, this, &LessonEditor::takeViewRequested);
    connect(m_step, &LessonStepEditor::showRequested, this, &LessonEditor::showRequested);
    connect(m_step, &LessonStepEditor::solveRequested, this, &LessonEditor::solveRequested);
    connect(m_step, &LessonStepEditor::goOnRequested, this,
            [this] { change([](Lesson& lesson, std::size_t& step) { lesson.steps.at(step).set.reset(); }); });
    connect(m_step, &LessonStepEditor::unsolveRequested, this,
            [this] { change([](Lesson& lesson, std::size_t& step) { lesson.steps.at(step).solved.reset(); }); });
    connect(m_step, &LessonStepEditor::answerAddRequested, this,
            [this] { change([](Lesson& lesson, std::size_t& step) { addAnswer(lesson, step); }); });
    connect(m_step, &LessonStepEditor::answerRemoveRequested, this, [this](int answer) {
        change([answer](Lesson& lesson, std::size_t& step) {
            removeAnswer(lesson, step, static_cast<std::size_t>(answer));
        });
    });
}

void LessonEditor::setDraft(const LessonDraft& draft) {
    m_draft = draft;
    showAll();
}

/// Takes what was typed.
void LessonEditor::take() {
    if (m_showing) return;
    text().title = m_title->text().toStdString();
    text().summary = m_summary->toPlainText().toStdString();
    m_draft.lesson.minutes = m_minutes->value();
    if (hasStep()) m_step->takeInto(m_draft.lesson.steps[m_draft.step], text().steps[m_draft.step]);
    emit edited();
}

void LessonEditor::change(const std::function<void(Lesson& lesson, std::size_t& step)>& change) {
    change(m_draft.lesson, m_draft.step);
    showAll();
    emit edited();
}

void LessonEditor::showAll() {
    const QScopedValueRollback showing(m_showing, true);
    const QString title = QString::fromStdString(text().title);
    if (m_title->text() != title) m_title->setText(title);
    setWords(*m_summary, text().summary);
    m_minutes->setValue(m_draft.lesson.minutes);
    m_language->clear();
    for (const LessonText& each : m_draft.lesson.texts) m_language->addItem(QString::fromStdString(each.language));
    m_language->setCurrentIndex(static_cast<int>(m_draft.language));
    m_language->setVisible(m_draft.lesson.texts.size() > 1);
    showSteps();
    showStep();
}

void LessonEditor::showSteps() {
    const QScopedValueRollback showing(m_showing, true);
    const auto count = static_cast<int>(m_draft.lesson.steps.size());
    while (m_steps->count() > count) delete m_steps->takeItem(count);
    while (m_steps->count() < count) m_steps->addItem(QString());
    for (int i = 0; i < count; ++i) {
        const auto step = static_cast<std::size_t>(i);
        const bool wrong = std::ranges::find(m_problems, std::optional(step), &LessonProblem::step) != m_problems.end();
        const QString title = QString::fromStdString(text().steps[step].title).trimmed();
        m_steps->item(i)->setText(tr("%1%2  %3").arg(wrong ? QStringLiteral("⚠ ") : QString()).arg(i + 1).arg(title));
    }
    m_steps->setCurrentRow(hasStep() ? static_cast<int>(m_draft.step) : -1);
}

void LessonEditor::showStep() {
    const QScopedValueRollback showing(m_showing, true);
    m_step->setVisible(hasStep());
    const QString none = tr("No step is chosen.");
    enableOrSayWhy(*m_remove, hasStep(), none);
    enableOrSayWhy(*m_up, hasStep() && m_draft.step > 0, tr("It is the first step."));
    enableOrSayWhy(*m_down, hasStep() && m_draft.step + 1 < m_draft.lesson.steps.size(), tr("It is the last step."));
    if (hasStep()) m_step->setStep(m_draft.lesson.steps[m_draft.step], text().steps[m_draft.step]);
    showStepProblems();
}

void LessonEditor::setProblems(const std::vector<LessonProblem>& problems) {
    m_problems = problems;
    const auto isHere = [this](const LessonProblem& each) {
        return !each.language || *each.language == m_draft.language;
    };
    const auto sentenceOf = [&](LessonField field) {
        const auto found = std::ranges::find_if(
            m_problems, [&](const LessonProblem& each) { return each.field == field && !each.step && isHere(each); });
        return found == m_problems.end() ? QString() : QString::fromStdString(found->sentence);
    };
    showProblem(*m_titleProblem, sentenceOf(LessonField::title));
    showProblem(*m_summaryProblem, sentenceOf(LessonField::summary));
    QString first;
    if (!m_problems.empty()) {
        const LessonProblem& problem = m_problems.front();
        first = QString::fromStdString(problem.sentence);
        if (problem.step) first = tr("Step %1: %2").arg(*problem.step + 1).arg(first);
        if (!isHere(problem))
            first = tr("%1: %2").arg(QString::fromStdString(m_draft.lesson.texts[*problem.language].language), first);
    }
    showProblem(*m_problem, first);
    for (QWidget* each :
         {static_cast<QWidget*>(m_play), static_cast<QWidget*>(m_save), static_cast<QWidget*>(m_handout)})
        enableOrSayWhy(*each, m_problems.empty(), first);
    showSteps();
    showStepProblems();
}

void LessonEditor::showStepProblems() {
    QList<LessonProblem> own;
    for (const LessonProblem& each : m_problems)
        if (each.step == m_draft.step && (!each.language || *each.language == m_draft.language)) own << each;
    m_step->setProblems(own);
}

void LessonEditor::setViewIsOfLesson(bool isOfLesson) {
    enableOrSayWhy(*m_add, isOfLesson, tr("The lesson's scan is not open. \"Show it\" opens it."));
    m_step->setViewIsOfLesson(isOfLesson);
}

}  // namespace echolucent
