#include "widgets/lesson/lesson_question_editor.h"

#include <QFontMetrics>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QRadioButton>
#include <QScopedValueRollback>
#include <QToolButton>
#include <QVBoxLayout>
#include <utility>

#include "widgets/controls/panel_controls.h"

namespace echolucent {

QPlainTextEdit* wordsEdit(const QString& name, const QString& accessibleName, const QString& placeholder, int lines,
                          QWidget* parent) {
    auto* edit = named(new QPlainTextEdit(parent), name, accessibleName);
    edit->setPlaceholderText(placeholder);
    edit->setTabChangesFocus(true);
    constexpr int rim = 12;  // pixels: frame and margin of the text
    edit->setFixedHeight(lines * QFontMetrics(edit->font()).lineSpacing() + rim);
    return edit;
}

void setWords(QPlainTextEdit& edit, const std::string& text) {
    if (const QString words = QString::fromStdString(text); edit.toPlainText() != words) edit.setPlainText(words);
}

LessonQuestionEditor::LessonQuestionEditor(QWidget* parent)
    : QWidget(parent),
      m_words(wordsEdit("lessons.editor.question.words", tr("Question"), tr("A question; empty for none"), 2, this)),
      m_explanation(wordsEdit("lessons.editor.question.explanation", tr("Explanation of the answer"),
                              tr("What follows from the right answer"), 2, this)),
      m_add(named(new QToolButton(this), "lessons.editor.question.add", tr("Add an answer"),
                  tr("A question has 2 to 6 answers. The marked one is right"))),
      m_rows(new QVBoxLayout) {
    setObjectName("lessons.editor.question");
    setAccessibleName(tr("Question and answers"));
    m_add->setText(tr("Add an answer"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(m_words);
    column->addLayout(m_rows);
    column->addWidget(m_add, 0, Qt::AlignLeft);
    column->addWidget(m_explanation);
    const auto tell = [this] {
        if (!m_showing) emit edited();
    };
    connect(m_words, &QPlainTextEdit::textChanged, this, tell);
    connect(m_explanation, &QPlainTextEdit::textChanged, this, tell);
    connect(m_add, &QToolButton::clicked, this, &LessonQuestionEditor::addRequested);
}

void LessonQuestionEditor::setQuestion(const LessonStepText& words, std::size_t right) {
    const QScopedValueRollback showing(m_showing, true);
    setWords(*m_words, words.question);
    setWords(*m_explanation, words.explanation);
    if (m_list.size() != static_cast<qsizetype>(words.answers.size())) {
        removeRows();
        for (std::size_t i = 0; i < words.answers.size(); ++i) addRow();
    }
    for (qsizetype i = 0; i < m_list.size(); ++i) {
        const QString answer = QString::fromStdString(words.answers[static_cast<std::size_t>(i)]);
        if (m_list[i].words->text() != answer) m_list[i].words->setText(answer);
        m_list[i].right->setChecked(i == static_cast<qsizetype>(right));
    }
    enableOrSayWhy(*m_add, words.answers.size() < mostLessonAnswers, tr("A question has at most 6 answers."));
}

void LessonQuestionEditor::takeInto(LessonStepText& words) const {
    words.question = m_words->toPlainText().toStdString();
    words.explanation = m_explanation->toPlainText().toStdString();
    words.answers.clear();
    for (const Row& row : m_list) words.answers.push_back(row.words->text().toStdString());
}

std::size_t LessonQuestionEditor::right() const {
    for (qsizetype i = 0; i < m_list.size(); ++i)
        if (m_list[i].right->isChecked()) return static_cast<std::size_t>(i);
    return 0;
}

void LessonQuestionEditor::removeRows() {
    for (const Row& row : std::as_const(m_list)) {
        for (QWidget* each : row.box->findChildren<QWidget*>()) each->setObjectName({});
        row.box->hide();
        row.box->deleteLater();
    }
    m_list.clear();
}

void LessonQuestionEditor::addRow() {
    const int place = static_cast<int>(m_list.size());
    const auto name = [place](const char* what) {
        return QStringLiteral("lessons.editor.question.%1.%2").arg(what).arg(place);
    };
    Row row;
    row.box = new QWidget(this);
    auto* line = new QHBoxLayout(row.box);
    line->setContentsMargins(0, 0, 0, 0);
    row.right = named(new QRadioButton(row.box), name("right"), tr("Answer %1 is right").arg(place + 1),
                      tr("This answer is the right one"));
    row.right->setAutoExclusive(false);
    row.words = named(new QLineEdit(row.box), name("answer"), tr("Answer %1").arg(place + 1));
    row.words->setPlaceholderText(tr("An answer"));
    auto* remove = named(new QToolButton(row.box), name("remove"), tr("Remove answer %1").arg(place + 1));
    remove->setText(QStringLiteral("×"));
    line->addWidget(row.right);
    line->addWidget(row.words, 1);
    line->addWidget(remove);
    m_rows->addWidget(row.box);
    m_list << row;
    row.box->show();
    connect(row.right, &QRadioButton::clicked, this, [this, place] {
        for (qsizetype i = 0; i < m_list.size(); ++i) m_list[i].right->setChecked(i == place);
        emit edited();
    });
    connect(row.words, &QLineEdit::textEdited, this, &LessonQuestionEditor::edited);
    connect(remove, &QToolButton::clicked, this, [this, place] { emit removeRequested(place); });
}

}  // namespace echolucent
