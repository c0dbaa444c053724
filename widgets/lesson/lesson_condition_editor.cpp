#include "widgets/lesson/lesson_condition_editor.h"

#include <QComboBox>
#include <QCompleter>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QStringListModel>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <limits>
#include <utility>

#include "processing/lesson/lesson_draft.h"
#include "widgets/controls/panel_controls.h"

namespace echolucent {

namespace {

enum Rule { all, one };

struct KindWords {
    ConditionKind kind;
    const char* words;
};
constexpr KindWords kinds[] = {{ConditionKind::equal, QT_TRANSLATE_NOOP("LessonConditionEditor", "is")},
                               {ConditionKind::notEqual, QT_TRANSLATE_NOOP("LessonConditionEditor", "is not")},
                               {ConditionKind::less, QT_TRANSLATE_NOOP("LessonConditionEditor", "is below")},
                               {ConditionKind::greater, QT_TRANSLATE_NOOP("LessonConditionEditor", "is above")},
                               {ConditionKind::between, QT_TRANSLATE_NOOP("LessonConditionEditor", "is between")},
                               {ConditionKind::present, QT_TRANSLATE_NOOP("LessonConditionEditor", "is there")}};

ConditionKind kindOf(const QComboBox& choice) { return static_cast<ConditionKind>(choice.currentData().toInt()); }

}  // namespace

LessonConditionEditor::LessonConditionEditor(QWidget* parent)
    : QWidget(parent),
      m_names(new QStringListModel(this)),
      m_rule(named(new QComboBox(this), "lessons.editor.condition.rule", tr("How many comparisons must hold"),
                   tr("The step is done once all of them hold, or once one of them does"))),
      m_nested(
          new QLabel(tr("The condition holds lists within each other. It stays as it is until you add a comparison, "
                        "which takes its place."),
                     this)),
      m_rows(new QVBoxLayout) {
    setObjectName("lessons.editor.condition");
    setAccessibleName(tr("When the step is done"));
    m_nested->setObjectName("lessons.editor.condition.nested");
    m_nested->setAccessibleName(tr("What is not edited here"));
    m_nested->setWordWrap(true);
    m_rule->addItem(tr("all of them hold"), static_cast<int>(ConditionKind::all));
    m_rule->addItem(tr("one of them holds"), static_cast<int>(ConditionKind::any));
    wheelNeedsFocus(m_rule);
    auto* add = named(new QToolButton(this), "lessons.editor.condition.add", tr("Add a comparison"),
                      tr("Without a comparison the step is only read"));
    add->setText(tr("Add a comparison"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(m_nested);
    column->addWidget(m_rule);
    column->addLayout(m_rows);
    column->addWidget(add, 0, Qt::AlignLeft);
    connect(add, &QToolButton::clicked, this, [this] {
        addRow({ConditionKind::equal});
        take();
        m_list.last().name->setFocus();
    });
    connect(m_rule, &QComboBox::activated, this, &LessonConditionEditor::take);
    showRule();
}

void LessonConditionEditor::setNames(const QStringList& names) {
    if (names == m_names->stringList()) return;
    QStringList typed;  // a combo box forgets it with its entries
    for (const Row& row : std::as_const(m_list)) {
        typed << row.name->currentText();
        row.name->blockSignals(true);
    }
    m_names->setStringList(names);
    for (qsizetype i = 0; i < m_list.size(); ++i) {
        m_list[i].name->setCurrentIndex(-1);
        m_list[i].name->setEditText(typed[i]);
        m_list[i].name->blockSignals(false);
    }
}

void LessonConditionEditor::setCondition(const std::optional<LessonCondition>& condition) {
    if (condition == m_condition) return;
    m_condition = condition;
    for (const Row& row : std::as_const(m_list)) {
        row.box->hide();
        row.box->deleteLater();
        row.box->setObjectName({});
        for (QWidget* each : row.box->findChildren<QWidget*>()) each->setObjectName({});
    }
    m_list.clear();
    for (const LessonCondition& comparison : comparisonsIn(condition).value_or(std::vector<LessonCondition>{}))
        addRow(comparison);
    if (condition && condition->kind == ConditionKind::any)
        m_rule->setCurrentIndex(Rule::one);
    else
        m_rule->setCurrentIndex(Rule::all);
    showRule();
}

void LessonConditionEditor::addRow(const LessonCondition& comparison) {
    Row row;
    row.box = new QWidget(this);
    auto* column = new QVBoxLayout(row.box);
    column->setContentsMargins(0, 0, 0, 0);
    auto* first = new QHBoxLayout;
    auto* second = new QHBoxLayout;
    row.name = new QComboBox(row.box);
    row.name->setEditable(true);
    row.name->setInsertPolicy(QComboBox::NoInsert);
    row.name->setModel(m_names);
    row.name->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    row.name->setMinimumContentsLength(12);
    row.name->setToolTip(tr("A value of the document, or a number that the window measures"));
    row.name->completer()->setFilterMode(Qt::MatchContains);
    row.name->completer()->setCompletionMode(QCompleter::PopupCompletion);
    row.name->setCurrentIndex(-1);
    row.name->setEditText(QString::fromStdString(comparison.name));
    wheelNeedsFocus(row.name);
    auto* remove = new QToolButton(row.box);
    remove->setText(QStringLiteral("×"));
    remove->setToolTip(tr("Removes this comparison"));
    row.kind = new QComboBox(row.box);
    for (const KindWords& each : kinds) row.kind->addItem(tr(each.words), static_cast<int>(each.kind));
    row.kind->setCurrentIndex(row.kind->findData(static_cast<int>(comparison.kind)));
    wheelNeedsFocus(row.kind);
    row.value = new QLineEdit(row.box);
    row.value->setMinimumWidth(40);
    if (!comparison.name.empty()) row.value->setText(QString::fromStdString(typedOf(comparison.value)));
    row.value->setToolTip(tr("A number, a word, true, false or null. It is filled in with the present value"));
    row.largest = new QLineEdit(row.box);
    row.largest->setMinimumWidth(40);
    row.largest->setText(QString::fromStdString(typedOf(comparison.largest)));
    row.largest->setToolTip(tr("The largest number that holds"));
    first->addWidget(row.name, 1);
    first->addWidget(remove);
    second->addWidget(row.kind);
    second->addWidget(row.value, 1);
    second->addWidget(row.largest, 1);
    column->addLayout(first);
    column->addLayout(second);
    m_rows->addWidget(row.box);
    m_list << row;
    nameRows();
    show(row);
    const auto changeName = [this, row] {
        fillIn(row);
        take();
    };
    connect(row.name, &QComboBox::editTextChanged, this, &LessonConditionEditor::take);
    connect(row.name, &QComboBox::activated, this, changeName);
    connect(row.name->lineEdit(), &QLineEdit::editingFinished, this, changeName);
    connect(row.kind, &QComboBox::activated, this, [this, row] {
        show(row);
        take();
    });
    connect(row.value, &QLineEdit::textEdited, this, &LessonConditionEditor::take);
    connect(row.largest, &QLineEdit::textEdited, this, &LessonConditionEditor::take);
    connect(remove, &QToolButton::clicked, this, [this, box = row.box] { removeRow(box); });
    row.box->show();
}

void LessonConditionEditor::nameRows() {
    for (qsizetype i = 0; i < m_list.size(); ++i) {
        const auto name = [i](const char* what) {
            return QStringLiteral("lessons.editor.condition.%1.%2").arg(what).arg(i);
        };
        const Row& row = m_list[i];
        named(row.name, name("name"), tr("Value"), row.name->toolTip());
        named(row.kind, name("kind"), tr("Comparison"));
        named(row.value, name("value"), tr("Compared with"), row.value->toolTip());
        named(row.largest, name("largest"), tr("Largest"), row.largest->toolTip());
        if (auto* remove = row.box->findChild<QToolButton*>())
            named(remove, name("remove"), tr("Remove the comparison"), remove->toolTip());
    }
    showRule();
}

void LessonConditionEditor::removeRow(QWidget* box) {
    const auto place = std::ranges::find(m_list, box, &Row::box);
    if (place == m_list.end()) return;
    box->hide();
    for (QWidget* each : box->findChildren<QWidget*>()) each->setObjectName({});
    box->deleteLater();
    m_list.erase(place);
    nameRows();
    take();
}

/// A comparison that needs no value, or two of them, shows as many fields.
void LessonConditionEditor::show(const Row& row) {
    row.value->setVisible(kindOf(*row.kind) != ConditionKind::present);
    row.largest->setVisible(kindOf(*row.kind) == ConditionKind::between);
}

void LessonConditionEditor::fillIn(const Row& row) {
    if (!row.value->text().isEmpty() || !m_present) return;
    const auto value = m_present(row.name->currentText().trimmed().toStdString());
    if (!value) return;
    row.value->setText(QString::fromStdString(typedOf(*value)));
    row.largest->setText(row.value->text());
}

void LessonConditionEditor::take() {
    std::vector<LessonCondition> comparisons;
    for (const Row& row : std::as_const(m_list)) {
        LessonCondition comparison{kindOf(*row.kind), row.name->currentText().trimmed().toStdString()};
        if (comparison.kind != ConditionKind::present) comparison.value = valueTyped(row.value->text().toStdString());
        if (comparison.kind == ConditionKind::between) {
            const DocumentValue largest = valueTyped(row.largest->text().toStdString());
            // Nothing is between a number and one that was not typed.
            comparison.largest = std::holds_alternative<double>(largest) ? std::get<double>(largest)
                                                                         : -std::numeric_limits<double>::max();
        }
        comparisons.push_back(std::move(comparison));
    }
    const auto condition = conditionOf(static_cast<ConditionKind>(m_rule->currentData().toInt()), comparisons);
    showRule();
    if (condition == m_condition) return;
    m_condition = condition;
    showRule();
    emit edited();
}

void LessonConditionEditor::showRule() {
    m_rule->setVisible(m_list.size() > 1);
    m_nested->setVisible(m_list.isEmpty() && m_condition.has_value());
}

}  // namespace echolucent
