#include "widgets/panels/measurements_panel.h"

#include <QComboBox>
#include <QFormLayout>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSignalBlocker>
#include <QTextCursor>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

#include "processing/one_line.h"
#include "widgets/controls/panel_controls.h"

namespace echolucent {

namespace {

constexpr std::array<MeasurementKind, 2> allKinds{MeasurementKind::distance, MeasurementKind::angle};

/// A distance that sonographers measure of a fetus.
struct UsualName {
    const char* abbreviation;
    const char* words;
};
constexpr std::array usualNames{
    UsualName{"BPD", QT_TRANSLATE_NOOP("echolucent::MeasurementsPanel", "biparietal diameter")},
    UsualName{"OFD", QT_TRANSLATE_NOOP("echolucent::MeasurementsPanel", "occipitofrontal diameter")},
    UsualName{"TCD", QT_TRANSLATE_NOOP("echolucent::MeasurementsPanel", "transcerebellar diameter")},
    UsualName{"FL", QT_TRANSLATE_NOOP("echolucent::MeasurementsPanel", "femur length")},
    UsualName{"HL", QT_TRANSLATE_NOOP("echolucent::MeasurementsPanel", "humerus length")},
    UsualName{"CRL", QT_TRANSLATE_NOOP("echolucent::MeasurementsPanel", "crown-rump length")},
    UsualName{"NT", QT_TRANSLATE_NOOP("echolucent::MeasurementsPanel", "nuchal translucency")}};

QString measureToolText(MeasurementKind kind) {
    QString text = textOf(nameOf(kind));
    text[0] = text[0].toUpper();
    return text;
}

QString tipOf(MeasurementKind kind) {
    return kind == MeasurementKind::distance
               ? MeasurementsPanel::tr("Click two places in a plane, or two on what the 3D picture shows (M)")
               : MeasurementsPanel::tr("Click three places in a plane; the angle is that at the second (Shift + M)");
}

}  // namespace

MeasurementsPanel::MeasurementsPanel(QWidget* parent) : QWidget(parent) {
    setObjectName("measurements");
    setAccessibleName(tr("Measurements"));
    auto* group = new QGroupBox(tr("Measurements"));
    auto* column = new QVBoxLayout(group);
    column->setContentsMargins(6, 6, 6, 6);
    auto* tools = new QHBoxLayout;
    for (const MeasurementKind kind : allKinds) {
        auto* button = named(new QToolButton, "measurements." + textOf(nameOf(kind)),
                             tr("Measure: %1").arg(measureToolText(kind)), tipOf(kind));
        button->setText(measureToolText(kind));
        button->setCheckable(true);
        button->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
        connect(button, &QToolButton::clicked, this,
                [this, kind](bool on) { emit toolChosen(on ? std::optional(kind) : std::nullopt); });
        m_tools[static_cast<std::size_t>(kind)] = button;
        tools->addWidget(button);
    }
    column->addLayout(tools);
    column->addWidget(createList());
    auto* outer = new QVBoxLayout(this);
    outer->setContentsMargins(6, 6, 6, 0);
    outer->addWidget(group);
    setRows({});
}

QWidget* MeasurementsPanel::createList() {
    m_list = named(new QListWidget, "measurements.list", tr("List of measurements"),
                   tr("A click shows the volume and the plane in which it was measured"));
    m_list->setFixedHeight(84);
    m_list->installEventFilter(this);
    createName();
    createComment();
    auto* remove = named(new QPushButton(tr("Remove")), "measurements.remove", tr("Remove the selected measurement"),
                         tr("The measurement selected in the list (Delete in the list)"));
    auto* removeAll = named(new QPushButton(tr("Remove all")), "measurements.removeAll", tr("Remove all measurements"),
                            tr("Removes the measurements of all volumes"));
    connect(m_list, &QListWidget::itemClicked, this, [this] { emit chosen(selectedId()); });
    connect(m_list, &QListWidget::itemActivated, this, [this] { emit chosen(selectedId()); });
    connect(m_list, &QListWidget::itemDoubleClicked, this, [this] { m_name->setFocus(Qt::OtherFocusReason); });
    connect(m_list, &QListWidget::currentRowChanged, this, [this] {
        emit typingEnded();
        showTexts();
    });
    connect(remove, &QPushButton::clicked, this, &MeasurementsPanel::removeSelected);
    connect(removeAll, &QPushButton::clicked, this, &MeasurementsPanel::allRemoved);
    auto* row = new QHBoxLayout;
    row->addWidget(remove);
    row->addWidget(removeAll);
    m_listed = new QWidget;
    auto* texts = new QFormLayout;
    texts->setContentsMargins(0, 0, 0, 0);
    texts->addRow(labelFor(m_name, tr("Name")), m_name);
    texts->addRow(labelFor(m_comment, tr("Comment")), m_comment);
    auto* column = new QVBoxLayout(m_listed);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(m_list);
    column->addLayout(texts);
    column->addLayout(row);
    return m_listed;
}

void MeasurementsPanel::createName() {
    m_name = named(new QComboBox, "measurements.name", tr("Name of the selected measurement"),
                   tr("What was measured. It stands beside the value in pictures, lists and reports"));
    m_name->setEditable(true);
    m_name->setInsertPolicy(QComboBox::NoInsert);
    // Completing inline would make "AC" of a typed "A".
    m_name->setCompleter(nullptr);
    m_name->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_name->setMinimumContentsLength(6);
    wheelNeedsFocus(m_name);
    for (const UsualName& name : usualNames) {
        m_name->addItem(QString::fromLatin1(name.abbreviation));
        m_name->setItemData(m_name->count() - 1, tr(name.words), Qt::ToolTipRole);
    }
    m_name->setCurrentIndex(-1);
    QLineEdit* field = named(m_name->lineEdit(), "measurements.name.field", m_name->accessibleName());
    field->setMaxLength(static_cast<int>(longestMeasurementName));
    field->setPlaceholderText(tr("none"));
    connect(field, &QLineEdit::textEdited, this, [this](const QString& text) { emit nameTyped(selectedId(), text); });
    connect(field, &QLineEdit::editingFinished, this, &MeasurementsPanel::typingEnded);
    connect(field, &QLineEdit::returnPressed, this, [this] { m_list->setFocus(Qt::OtherFocusReason); });
    connect(m_name, &QComboBox::textActivated, this, [this](const QString& text) {
        // It also comes if the field is left with one of the names typed: then the focus goes where the person wants.
        if (!m_name->hasFocus()) return;
        emit typingEnded();
        emit nameTyped(selectedId(), text);
        emit typingEnded();
        // The next key is the window's, not a letter more.
        m_list->setFocus(Qt::OtherFocusReason);
    });
}

void MeasurementsPanel::createComment() {
    m_comment = named(new QPlainTextEdit, "measurements.comment", tr("Comment on the selected measurement"),
                      tr("It stands beside the value in the case report"));
    m_comment->setTabChangesFocus(true);
    m_comment->setFixedHeight(2 * m_comment->fontMetrics().lineSpacing() + 14);
    m_comment->installEventFilter(this);
    connect(m_comment, &QPlainTextEdit::textChanged, this, [this] {
        const std::size_t letters = letterCount(m_comment->toPlainText().toStdString());
        if (letters > longestMeasurementComment) {
            // What was typed or pasted last is what does not fit.
            QTextCursor cursor = m_comment->textCursor();
            cursor.movePosition(QTextCursor::PreviousCharacter, QTextCursor::KeepAnchor,
                                static_cast<int>(letters - longestMeasurementComment));
            cursor.removeSelectedText();  // this comes here again
            return;
        }
        emit commentTyped(selectedId(), m_comment->toPlainText());
    });
}

bool MeasurementsPanel::eventFilter(QObject* watched, QEvent* event) {
    if (watched == m_comment && event->type() == QEvent::FocusOut) emit typingEnded();
    if (watched == m_list && event->type() == QEvent::KeyPress) {
        switch (static_cast<QKeyEvent*>(event)->key()) {
            case Qt::Key_Delete: removeSelected(); return true;
            case Qt::Key_F2: m_name->setFocus(Qt::OtherFocusReason); return true;
            default: break;
        }
    }
    return QWidget::eventFilter(watched, event);
}

void MeasurementsPanel::removeSelected() {
    if (selectedId() != 0) emit removed(selectedId());
}

/// Shows name and comment of the selected measurement. What a person is typing stays as it is if the measurement has
/// got it.
void MeasurementsPanel::showTexts() {
    const int row = m_list->currentRow();
    const MeasurementRow shown = row < 0 ? MeasurementRow{} : m_rows[static_cast<std::size_t>(row)];
    const auto kept = [](const QString& typed, std::string (*as)(std::string_view)) {
        return QString::fromStdString(as(typed.toStdString()));
    };
    if (kept(m_name->currentText(), &measurementNameOf) != shown.name) m_name->setEditText(shown.name);
    if (kept(m_comment->toPlainText(), &measurementCommentOf) == shown.comment) return;
    const QSignalBlocker blocker(m_comment);
    m_comment->setPlainText(shown.comment);
}

int MeasurementsPanel::selectedId() const {
    const int row = m_list->currentRow();
    return row < 0 ? 0 : m_rows[static_cast<std::size_t>(row)].id;
}

void MeasurementsPanel::setRows(const std::vector<MeasurementRow>& rows) {
    const int selected = selectedId(), before = m_list->currentRow();
    // Select a new measurement. Otherwise keep the selection; if the selected measurement was removed, select the one
    // that stands in its place.
    const bool grown = rows.size() > m_rows.size();
    {
        const QSignalBlocker blocker(m_list);
        m_rows = rows;
        m_list->clear();
        for (const MeasurementRow& row : m_rows) {
            m_list->addItem(row.text);
            m_list->item(m_list->count() - 1)->setToolTip(literalToolTip(row.text));
        }
        const auto kept = std::ranges::find(m_rows, selected, &MeasurementRow::id);
        m_list->setCurrentRow(grown                  ? m_list->count() - 1
                              : kept == m_rows.end() ? std::min(before, m_list->count() - 1)
                                                     : static_cast<int>(kept - m_rows.begin()));
    }
    if (selectedId() != selected) emit typingEnded();
    showTexts();
    m_listed->setVisible(!m_rows.empty());
}

void MeasurementsPanel::setTool(std::optional<MeasurementKind> tool) {
    for (const MeasurementKind kind : allKinds) m_tools[static_cast<std::size_t>(kind)]->setChecked(kind == tool);
}

}  // namespace echolucent
