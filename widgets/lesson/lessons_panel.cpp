#include "widgets/lesson/lessons_panel.h"

#include <QButtonGroup>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QMenu>
#include <QMouseEvent>
#include <QPushButton>
#include <QRadioButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QStackedWidget>
#include <QTimer>
#include <QToolButton>
#include <QVBoxLayout>

#include "widgets/controls/panel_controls.h"
#include "widgets/lesson/lesson_editor.h"
#include "widgets/lesson/lesson_text_view.h"

namespace echolucent {

namespace {

/// The words of a radio button: as many lines as they need, of a stranger. A click on them chooses the button.
class AnswerWords : public LessonTextView {
public:
    AnswerWords(const LessonPage& page, int place, QRadioButton* button, QWidget* parent)
        : LessonTextView(parent), m_button(button) {
        setFocusPolicy(Qt::NoFocus);
        setTextInteractionFlags(Qt::NoTextInteraction);
        setImages(page.images);
        showMarkdown(page.answers[place]);
    }

protected:
    void mouseReleaseEvent(QMouseEvent* event) override {
        if (event->button() == Qt::LeftButton && rect().contains(event->pos())) m_button->click();
    }

private:
    QRadioButton* m_button;
};

QToolButton* tool(const QString& text, const QString& name, const QString& tip, QWidget* parent) {
    auto* button = named(new QToolButton(parent), name, text, tip);
    button->setText(text);
    return button;
}

}  // namespace

LessonsPanel::LessonsPanel(QWidget* parent)
    : QWidget(parent), m_pages(new QStackedWidget(this)), m_editor(new LessonEditor(m_pages)) {
    setObjectName("lessons");
    setAccessibleName(tr("Lessons"));
    m_pages->addWidget(createList());
    m_pages->addWidget(createPage());
    m_pages->addWidget(m_editor);
    auto* column = new QVBoxLayout(this);
    column->addWidget(m_pages);
}

QWidget* LessonsPanel::createList() {
    auto* page = new QWidget(m_pages);
    auto* column = new QVBoxLayout(page);
    column->setContentsMargins(0, 0, 0, 0);
    m_list = named(new QListWidget(page), "lessons.list", tr("Lessons"), tr("A double click begins a lesson"));
    m_list->setWordWrap(true);
    m_list->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    m_summary = named(new QLabel(page), "lessons.summary", tr("What the lesson is about"));
    m_summary->setTextFormat(Qt::MarkdownText);
    m_summary->setWordWrap(true);
    m_begin = named(new QPushButton(tr("Begin"), page), "lessons.begin", tr("Begin the lesson"),
                    tr("Opens the lesson's simulated scan. Your own study, document and history come back afterwards"));
    auto* open = tool(tr("Open a lesson…"), "lessons.open", tr("Opens a lesson from a folder"), page);
    auto* row = new QHBoxLayout;
    row->addWidget(m_begin);
    row->addStretch(1);
    row->addWidget(open);
    column->addWidget(m_list, 1);
    column->addWidget(m_summary);
    column->addLayout(row);
    column->addWidget(createAuthorRows(page));
    connect(m_list, &QListWidget::currentRowChanged, this, &LessonsPanel::showEntry);
    connect(m_list, &QListWidget::itemActivated, this, [this] { emit beginRequested(m_list->currentRow()); });
    connect(m_begin, &QPushButton::clicked, this, [this] { emit beginRequested(m_list->currentRow()); });
    connect(open, &QToolButton::clicked, this, &LessonsPanel::openRequested);
    showEntry(-1);
    return page;
}

/// The buttons of those who write lessons.
QWidget* LessonsPanel::createAuthorRows(QWidget* page) {
    auto* rows = new QWidget(page);
    auto* column = new QVBoxLayout(rows);
    column->setContentsMargins(0, 0, 0, 0);
    m_new = named(new QPushButton(tr("New lesson from my snapshots…"), rows), "lessons.new",
                  tr("New lesson from my snapshots"),
                  tr("Makes a lesson with a step a snapshot, and opens it to be written"));
    m_edit = tool(tr("Edit…"), "lessons.edit", tr("Opens a lesson to be written"), rows);
    m_edit->setPopupMode(QToolButton::InstantPopup);
    auto* menu = named(new QMenu(m_edit), "lessons.edit.menu", tr("Edit a lesson"));
    m_editCopy = menu->addAction(tr("A copy of the chosen lesson"));
    m_editCopy->setObjectName("lessons.editCopy");
    QAction* folder = menu->addAction(tr("A lesson in a folder…"));
    folder->setObjectName("lessons.editFolder");
    m_edit->setMenu(menu);
    m_draft = tool(tr("Continue my draft"), "lessons.draft", tr("Opens what was written and not saved"), rows);
    m_draft->setPopupMode(QToolButton::InstantPopup);
    m_draft->setMenu(named(new QMenu(m_draft), "lessons.draft.menu", tr("Continue my draft")));
    m_handout = tool(tr("Save handout…"), "lessons.handout",
                     tr("Writes the chosen lesson as a page that opens without a network"), rows);
    auto* row = new QHBoxLayout;
    row->addWidget(m_edit);
    row->addStretch(1);
    row->addWidget(m_draft);
    column->addWidget(m_handout, 0, Qt::AlignRight);
    column->addWidget(m_new);
    column->addLayout(row);
    connect(m_new, &QPushButton::clicked, this, &LessonsPanel::newRequested);
    connect(m_editCopy, &QAction::triggered, this, [this] { emit editCopyRequested(m_list->currentRow()); });
    connect(folder, &QAction::triggered, this, &LessonsPanel::editFolderRequested);
    connect(m_handout, &QToolButton::clicked, this, [this] { emit handoutRequested(m_list->currentRow()); });
    setDrafts({});
    return rows;
}

QWidget* LessonsPanel::createPage() {
    auto* page = new QWidget(m_pages);
    auto* column = new QVBoxLayout(page);
    column->setContentsMargins(0, 0, 0, 0);
    auto* head = new QHBoxLayout;
    m_lesson = secondaryLabel();
    m_lesson->setObjectName("lessons.lesson");
    m_lesson->setAccessibleName(tr("Lesson that is played"));
    m_lesson->setWordWrap(true);
    m_lesson->setTextFormat(Qt::PlainText);
    auto* leave =
        tool(tr("Leave"), "lessons.leave", tr("Ends the lesson. Your own study, document and history come back"), page);
    connect(leave, &QToolButton::clicked, this, &LessonsPanel::leaveRequested);
    head->addWidget(m_lesson, 1);
    head->addWidget(leave, 0, Qt::AlignTop);
    m_title = named(new QLabel(page), "lessons.title", tr("Step"));
    m_title->setWordWrap(true);
    m_title->setTextFormat(Qt::PlainText);
    QFont font = m_title->font();
    font.setBold(true);
    m_title->setFont(font);
    m_progress = named(secondaryLabel(), "lessons.progress", tr("Progress"));
    column->addLayout(head);
    column->addWidget(m_title);
    column->addWidget(m_progress);
    column->addWidget(createText(), 1);
    column->addWidget(createButtons());
    return page;
}

QWidget* LessonsPanel::createText() {
    m_scroll = new QScrollArea(m_pages);
    m_scroll->setObjectName("lessons.scroll");
    m_scroll->setFrameShape(QFrame::NoFrame);
    m_scroll->setWidgetResizable(true);
    m_scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_scroll->setFocusPolicy(Qt::NoFocus);
    auto* content = new QWidget(m_scroll);
    auto* column = new QVBoxLayout(content);
    column->setContentsMargins(0, 0, 4, 0);
    m_text = named(new LessonTextView(content), "lessons.text", tr("Text of the step"));
    m_hint = tool(tr("Hint"), "lessons.hint", tr("Shows how the step is done"), content);
    m_hint->setCheckable(true);
    m_hintText = named(new LessonTextView(content), "lessons.hintText", tr("Hint"));
    m_question = named(new LessonTextView(content), "lessons.question", tr("Question"));
    m_answers = new QWidget(content);
    m_answerRows = new QVBoxLayout(m_answers);
    m_answerRows->setContentsMargins(0, 0, 0, 0);
    m_verdict = named(new QLabel(content), "lessons.verdict", tr("Whether the answer is right"));
    m_verdict->setWordWrap(true);
    m_explanation = named(new LessonTextView(content), "lessons.explanation", tr("Explanation of the answer"));
    column->addWidget(m_text);
    column->addWidget(m_hint, 0, Qt::AlignLeft);
    column->addWidget(m_hintText);
    column->addWidget(m_question);
    column->addWidget(m_answers);
    column->addWidget(m_verdict);
    column->addWidget(m_explanation);
    column->addStretch(1);
    m_scroll->setWidget(content);
    connect(m_hint, &QToolButton::toggled, m_hintText, &QWidget::setVisible);
    return m_scroll;
}

QWidget* LessonsPanel::createButtons() {
    auto* buttons = new QWidget(m_pages);
    auto* column = new QVBoxLayout(buttons);
    column->setContentsMargins(0, 0, 0, 0);
    m_done = named(new QLabel(buttons), "lessons.done", tr("Whether the step is done"));
    m_done->setWordWrap(true);
    auto* row = new QHBoxLayout;
    m_back = tool(tr("Back"), "lessons.back", tr("Goes to the step before, as it was when it began"), buttons);
    m_reset = tool(tr("Reset"), "lessons.reset", tr("Sets everything as it was when this step began"), buttons);
    m_solve = tool(tr("Do it for me"), "lessons.skip", tr("Does what the step asks for, and stays"), buttons);
    m_next = named(new QPushButton(tr("Next"), buttons), "lessons.next", tr("Next step"),
                   tr("Goes to the next step. If this one is not done, does it first"));
    row->addWidget(m_back);
    row->addWidget(m_reset);
    row->addWidget(m_solve);
    row->addStretch(1);
    row->addWidget(m_next);
    column->addWidget(m_done);
    column->addLayout(row);
    connect(m_back, &QToolButton::clicked, this, &LessonsPanel::backRequested);
    connect(m_reset, &QToolButton::clicked, this, &LessonsPanel::resetRequested);
    connect(m_solve, &QToolButton::clicked, this, &LessonsPanel::solveRequested);
    connect(m_next, &QPushButton::clicked, this, &LessonsPanel::nextRequested);
    return buttons;
}

void LessonsPanel::setLessons(const QList<LessonEntry>& lessons) {
    m_asked = true;
    m_lessons = lessons;
    m_list->clear();
    for (const LessonEntry& lesson : lessons)
        m_list->addItem(tr("%1\n%2 minutes").arg(lesson.title).arg(lesson.minutes));
    m_list->setCurrentRow(lessons.isEmpty() ? -1 : 0);
}

void LessonsPanel::showEntry(int lesson) {
    m_summary->setText(m_lessons.value(lesson).summary);
    enableOrSayWhy(*m_begin, lesson >= 0, tr("Choose a lesson."));
    enableOrSayWhy(*m_editCopy, lesson >= 0, tr("Choose a lesson."));
    enableOrSayWhy(*m_handout, lesson >= 0, tr("Choose a lesson."));
}

void LessonsPanel::setWhyNoLesson(const QString& sentence) { enableOrSayWhy(*m_new, sentence.isEmpty(), sentence); }

void LessonsPanel::setDrafts(const QList<LessonDraftEntry>& drafts) {
    QMenu* menu = m_draft->menu();
    menu->clear();
    for (const LessonDraftEntry& draft : drafts) {
        QAction* action = menu->addAction(literalMenuText(draft.title.isEmpty() ? tr("without a title") : draft.title));
        action->setObjectName(QStringLiteral("lessons.draft.%1").arg(menu->actions().size() - 1));
        connect(action, &QAction::triggered, this, [this, folder = draft.folder] { emit draftRequested(folder); });
    }
    enableOrSayWhy(*m_draft, !drafts.isEmpty(), tr("Nothing was left unsaved."));
}

void LessonsPanel::showEditor() { m_pages->setCurrentWidget(m_editor); }

void LessonsPanel::showList() { m_pages->setCurrentIndex(0); }

void LessonsPanel::showPage(const LessonPage& page) {
    m_page = page;
    m_lesson->setText(page.lesson);
    m_title->setText(page.title);
    m_progress->setText(tr("Step %1 of %2").arg(page.number).arg(page.count));
    for (LessonTextView* view : {m_text, m_hintText, m_question, m_explanation}) view->setImages(page.images);
    m_text->showMarkdown(page.text);
    m_hintText->showMarkdown(page.hint);
    m_question->showMarkdown(page.question);
    m_explanation->showMarkdown(page.explanation);
    m_hint->setVisible(!page.hint.isEmpty());
    m_hint->setChecked(false);
    m_hintText->hide();
    m_question->setVisible(!page.question.isEmpty());
    showAnswers(page);
    m_back->setEnabled(page.number > 1);
    m_next->setText(page.number == page.count ? tr("Finish") : tr("Next"));
    m_solve->setVisible(page.task);
    showWhatIsDone();
    m_pages->setCurrentIndex(1);
    m_scroll->verticalScrollBar()->setValue(0);
}

void LessonsPanel::showAnswers(const LessonPage& page) {
    qDeleteAll(m_answers->findChildren<QWidget*>(Qt::FindDirectChildrenOnly));
    for (int i = 0; i < page.answers.size(); ++i) {
        auto* row = new QWidget(m_answers);
        auto* line = new QHBoxLayout(row);
        line->setContentsMargins(0, 0, 0, 0);
        auto* button = named(new QRadioButton(row), QStringLiteral("lessons.answer.%1").arg(i), page.answers[i]);
        button->setAutoExclusive(false);
        button->setChecked(page.answered && i == page.right);
        connect(button, &QRadioButton::clicked, this, [this, i] { answer(i); });
        line->addWidget(button, 0, Qt::AlignTop);
        line->addWidget(new AnswerWords(page, i, button, row), 1);
        m_answerRows->addWidget(row);
        row->show();
    }
    m_answers->setVisible(!page.answers.isEmpty());
    m_verdict->setVisible(page.answered);
    m_verdict->setText(page.answered ? tr("Right.") : QString());
    m_explanation->setVisible(page.answered && !page.explanation.isEmpty());
}

void LessonsPanel::answer(int place) {
    const QList<QRadioButton*> buttons = m_answers->findChildren<QRadioButton*>();
    for (QRadioButton* button : buttons)
        button->setChecked(button->objectName() == QStringLiteral("lessons.answer.%1").arg(place));
    const bool right = place == m_page.right;
    m_verdict->setText(right ? tr("Right.") : tr("No. Try again."));
    m_verdict->show();
    m_explanation->setVisible(right && !m_page.explanation.isEmpty());
    // The words get their places with the next events.
    QTimer::singleShot(0, this, [this] {
        if (m_explanation->isVisible()) m_scroll->ensureWidgetVisible(m_explanation);
        m_scroll->ensureWidgetVisible(m_verdict);
    });
    if (!right || m_page.answered) return;
    m_page.answered = true;
    showWhatIsDone();
    emit answeredRight();
}

void LessonsPanel::setDone(bool done) {
    m_page.done = done;
    showWhatIsDone();
}

void LessonsPanel::showWhatIsDone() {
    const bool asks = !m_page.answers.isEmpty();
    const bool done = m_page.done && (!asks || m_page.answered);
    m_done->setVisible(m_page.task || asks);
    m_done->setText(done ? tr("✓ Done.")
                    : m_page.done && asks
                        ? m_page.task ? tr("✓ Done. The question is open.") : tr("The question is open.")
                        : tr("To do."));
}

void LessonsPanel::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    if (std::exchange(m_asked, true)) return;
    emit listWanted();
}

}  // namespace echolucent
