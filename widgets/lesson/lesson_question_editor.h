// The question of a lesson's step: its words, its answers, and which of them is right.
#pragma once

#include <QList>
#include <QWidget>
#include <cstddef>

#include "processing/lesson/lesson.h"

class QLineEdit;
class QPlainTextEdit;
class QRadioButton;
class QToolButton;
class QVBoxLayout;

namespace echolucent {

/// A plain text edit for several lines, `lines` high. Tab leaves it.
[[nodiscard]] QPlainTextEdit* wordsEdit(const QString& name, const QString& accessibleName, const QString& placeholder,
                                        int lines, QWidget* parent);
/// Shows a text in it, unless it is there already; the cursor stays then. Emits textChanged() if it changes.
void setWords(QPlainTextEdit& edit, const std::string& text);

/// Objects: lessons.editor.question (this), .words, .add, .explanation; of each answer N from 0 on .answer.N, .right.N,
/// .remove.N. No setter emits a signal.
class LessonQuestionEditor : public QWidget {
    Q_OBJECT

public:
    explicit LessonQuestionEditor(QWidget* parent = nullptr);

    void setQuestion(const LessonStepText& words, std::size_t right);
    /// Question, answers and explanation as they were typed.
    void takeInto(LessonStepText& words) const;
    /// The place of the answer that is marked right; 0 if there are no answers.
    [[nodiscard]] std::size_t right() const;

signals:
    void edited();
    /// An answer is to be added, or removed, in all languages.
    void addRequested();
    void removeRequested(int answer);

private:
    struct Row {
        QWidget* box = nullptr;
        QRadioButton* right = nullptr;
        QLineEdit* words = nullptr;
    };
    void addRow();
    void removeRows();

    QPlainTextEdit *m_words, *m_explanation;
    QToolButton* m_add;
    QVBoxLayout* m_rows;
    QList<Row> m_list;
    bool m_showing = false;
};

}  // namespace echolucent
