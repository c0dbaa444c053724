// When a step of a lesson is done: comparisons, chosen from a closed list.
#pragma once

#include <QList>
#include <QStringList>
#include <QWidget>
#include <functional>
#include <optional>
#include <vector>

#include "processing/lesson/lesson_condition.h"

class QComboBox;
class QLabel;
class QLineEdit;
class QStringListModel;
class QToolButton;
class QVBoxLayout;

namespace echolucent {

/// Edits a condition. It may be empty, one comparison, or several. Of several, all or one must hold. If a condition
/// nests deeper, the editor keeps it until a person replaces it. Objects: lessons.editor.condition (this), .rule, .add,
/// .nested; of each comparison N from 0 on .name.N, .kind.N, .value.N, .largest.N, .remove.N. No setter emits a signal.
class LessonConditionEditor : public QWidget {
    Q_OBJECT

public:
    explicit LessonConditionEditor(QWidget* parent = nullptr);

    void setCondition(const std::optional<LessonCondition>& condition);
    [[nodiscard]] const std::optional<LessonCondition>& condition() const { return m_condition; }
    /// The names that are offered.
    void setNames(const QStringList& names);
    /// Gives the present value of a name, which fills in a comparison that has none yet.
    void setPresentValue(NamedValue value) { m_present = std::move(value); }

signals:
    void edited();

private:
    struct Row {
        QWidget* box = nullptr;
        QComboBox *name = nullptr, *kind = nullptr;
        QLineEdit *value = nullptr, *largest = nullptr;
    };
    void addRow(const LessonCondition& comparison);
    void nameRows();
    void removeRow(QWidget* box);
    void show(const Row& row);
    void fillIn(const Row& row);
    void take();
    void showRule();

    std::optional<LessonCondition> m_condition;
    NamedValue m_present;
    QStringListModel* m_names;
    QComboBox* m_rule;
    QLabel* m_nested;
    QVBoxLayout* m_rows;
    QList<Row> m_list;
};

}  // namespace echolucent
