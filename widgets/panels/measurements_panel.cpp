#include "widgets/panels/measurements_panel.h"

#include <QAbstractItemView>
#include <QComboBox>
#include <QCoreApplication>
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
#include <QStandardItemModel>
#include <QStyledItemDelegate>
#include <QTextCursor>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

#include "processing/one_line.h"
#include "widgets/controls/panel_controls.h"

namespace echolucent {

namespace {

constexpr std::array<MeasurementKind, 2> allKinds{MeasurementKind::distance, MeasurementKind::angle};

/// What sonographers measure with a straight line or an angle. No tool measures a circumference or an area, so that no
/// name of one is proposed.
struct UsualName {
    const char* abbreviation;  ///< becomes the name
    const char* words;         ///< null if this is the title of the names that follow
};
constexpr std::array usualNames{
    UsualName{QT_TRANSLATE_NOOP("echolucent::MeasurementsPanel", "Fetal biometry"), nullptr},
    UsualName{"BPD", QT_TRANSLATE_NOOP("echolucent::MeasurementsPanel", "biparietal diameter")},
    UsualName{"OFD", QT_TRANSLATE_NOOP("echolucent::MeasurementsPanel", "occipitofrontal diameter")},
    UsualName{"TCD", QT_TRANSLATE_NOOP("echolucent::MeasurementsPanel", "transcerebellar diameter")},
    UsualName{"APAD", QT_TRANSLATE_NOOP("echolucent::MeasurementsPanel", "anteroposterior abdomen")},
    UsualName{"TAD", QT_TRANSLATE_NOOP("echolucent::MeasurementsPanel", "transverse abdomen")},
    UsualName{"FL", QT_TRANSLATE_NOOP("echolucent::MeasurementsPanel", "femur length")},
    UsualName{"HL", QT_TRANSLATE_NOOP("echolucent::MeasurementsPanel", "humerus length")},
    UsualName{"CRL", QT_TRANSLATE_NOOP("echolucent::MeasurementsPanel", "crown-rump length")},
    UsualName{"NT", QT_TRANSLATE_NOOP("echolucent::MeasurementsPanel", "nuchal translucency")},
    UsualName{QT_TRANSLATE_NOOP("echolucent::MeasurementsPanel", "Heart"), nullptr},
    UsualName{"LV", QT_TRANSLATE_NOOP("echolucent::MeasurementsPanel", "left ventricle")},
    UsualName{"RV", QT_TRANSLATE_NOOP("echolucent::MeasurementsPanel", "right ventricle")},
    UsualName{"LA", QT_TRANSLATE_NOOP("echolucent::MeasurementsPanel", "left atrium")},
    UsualName{"RA", QT_TRANSLATE_NOOP("echolucent::MeasurementsPanel", "right atrium")},
    UsualName{"IVS", QT_TRANSLATE_NOOP("echolucent::MeasurementsPanel", "ventricular septum")},
    UsualName{"MV", QT_TRANSLATE_NOOP("echolucent::MeasurementsPanel", "mitral annulus")},
    UsualName{"TV", QT_TRANSLATE_NOOP("echolucent::MeasurementsPanel", "tricuspid annulus")},
    UsualName{"Ao", QT_TRANSLATE_NOOP("echolucent::MeasurementsPanel", "aorta")},
    UsualName{"PA", QT_TRANSLATE_NOOP("echolucent::MeasurementsPanel", "pulmonary artery")},
    UsualName{"CD", QT_TRANSLATE_NOOP("echolucent::MeasurementsPanel", "cardiac diameter")},
    UsualName{"TD", QT_TRANSLATE_NOOP("echolucent::MeasurementsPanel", "thoracic diameter")},
    UsualName{"axis", QT_TRANSLATE_NOOP("echolucent::MeasurementsPanel", "cardiac axis, an angle")}};

constexpr int wordsRole = Qt::UserRole;

/// The list of usual names shows each with its words, while the field takes the name alone.
class NamesWithWords : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;

protected:
    void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override {
        QStyledItemDelegate::initStyleOption(option, index);
        const QString words = index.data(wordsRole).toString();
        if (!words.isEmpty()) option->text += QStringLiteral(" – ") + words;
    }
};

void addUsualNames(QComboBox& names) {
    auto* model = new QStandardItemModel(&names);
    for (const UsualName& name : usualNames) {
        auto* item = new QStandardItem(name.words ? QString::fromLatin1(name.abbreviation)
                                                  : MeasurementsPanel::tr(name.abbreviation));
        if (name.words) {
            item->setData(MeasurementsPanel::tr(name.words), wordsRole);
        } else {
            QFont font = names.font();
            font.setBold(true);
            item->setFont(font);
            item->setFlags(Qt::NoItemFlags);
        }
        model->appendRow(item);
    }
    names.setModel(model);
    names.setItemDelegate(new NamesWithWords(&names));
    names.setMaxVisibleItems(static_cast<int>(usualNames.size()));
    names.setCurrentIndex(-1);
}

/// Whether a key in the list begins a name: a letter or another sign, no blank.
bool beginsName(const QKeyEvent& key) {
    const QString text = key.text();
    return !(key.modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier)) && !text.isEmpty() &&
           text.front().isPrint() && !text.front().isSpace();
}

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
    orderTabs();
    setRows({});
}

/// From a field Tab leads to the next field and to the list, and to what removes at last.
void MeasurementsPanel::orderTabs() {
    const std::array<QWidget*, 5> order{m_name, m_comment, m_list, m_remove, m_removeAll};
    for (std::size_t i = 1; i < order.size(); ++i) setTabOrder(order[i - 1], order[i]);
}

QWidget* MeasurementsPanel::createList() {
    m_list = named(new QListWidget, "measurements.list", tr("List of measurements"),
                   tr("A click shows the volume and the plane in which it was measured"));
    m_list->setFixedHeight(84);
    m_list->installEventFilter(this);
    createName();
    createComment();
    m_remove = named(new QPushButton(tr("Remove")), "measurements.remove", tr("Remove the selected measurement"),
                     tr("The measurement selected in the list (Delete in the list)"));
    m_removeAll = named(new QPushButton(tr("Remove all")), "measurements.removeAll", tr("Remove all measurements"),
                        tr("Removes the measurements of all volumes"));
    connect(m_list, &QListWidget::itemClicked, this, [this] { emit chosen(selectedId()); });
    connect(m_list, &QListWidget::itemActivated, this, [this] { emit chosen(selectedId()); });
    connect(m_list, &QListWidget::itemDoubleClicked, this, [this] { m_name->setFocus(Qt::OtherFocusReason); });
    connect(m_list, &QListWidget::currentRowChanged, this, [this] {
        emit typingEnded();
        showTexts();
    });
    connect(m_remove, &QPushButton::clicked, this, &MeasurementsPanel::removeSelected);
    connect(m_removeAll, &QPushButton::clicked, this, &MeasurementsPanel::allRemoved);
    auto* row = new QHBoxLayout;
    row->addWidget(m_remove);
    row->addWidget(m_removeAll);
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
    addUsualNames(*m_name);
    m_name->installEventFilter(this);
    QLineEdit* field = named(m_name->lineEdit(), "measurements.name.field", m_name->accessibleName());
    field->setMaxLength(static_cast<int>(longestMeasurementName));
    field->setPlaceholderText(tr("choose or type"));
    connect(field, &QLineEdit::textEdited, this, [this](const QString& text) { emit nameTyped(selectedId(), text); });
    connect(field, &QLineEdit::editingFinished, this, &MeasurementsPanel::typingEnded);
    connect(field, &QLineEdit::returnPressed, this, &MeasurementsPanel::done);
    field->installEventFilter(this);
    connect(m_name, &QComboBox::textActivated, this, [this](const QString& text) {
        // It also comes if the field is left with one of the names typed: then the focus goes where the person wants.
        if (!m_name->hasFocus()) return;
        emit typingEnded();
        emit nameTyped(selectedId(), text);
        emit typingEnded();
        // The next key is the window's, not a letter more.
        emit done();
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
    if (watched != m_comment && watched != m_list &&
        (event->type() == QEvent::FocusOut || event->type() == QEvent::MouseButtonPress))
        m_asks = false;
    if (event->type() == QEvent::ShortcutOverride) {
        auto* key = static_cast<QKeyEvent*>(event);
        if (watched == m_list && beginsName(*key)) {
            key->accept();
            return true;
        }
        // While nothing was typed, undo and redo are the window's: they take back the measurement.
        const QLineEdit& field = *m_name->lineEdit();
        if (watched == m_name && ((key->matches(QKeySequence::Undo) && !field.isUndoAvailable()) ||
                                  (key->matches(QKeySequence::Redo) && !field.isRedoAvailable()))) {
            key->ignore();
            return true;
        }
    }
    if (event->type() == QEvent::KeyPress) {
        auto* key = static_cast<QKeyEvent*>(event);
        if (key->key() == Qt::Key_Escape) {
            const bool isOfWindow = watched != m_list && watched != m_comment && asks();
            emit done();
            return !isOfWindow;
        }
        if (watched == m_list) return takeKeyOfList(*key);
    }
    return QWidget::eventFilter(watched, event);
}

bool MeasurementsPanel::takeKeyOfList(QKeyEvent& key) {
    if (key.key() == Qt::Key_Delete) {
        removeSelected();
    } else if (key.key() == Qt::Key_F2) {
        m_name->setFocus(Qt::OtherFocusReason);
    } else if (beginsName(key) && selectedId() != 0) {
        goToName();
        QCoreApplication::sendEvent(m_name->lineEdit(), &key);
    } else {
        return false;
    }
    return true;
}

void MeasurementsPanel::goToName() {
    m_name->setFocus(Qt::OtherFocusReason);
    m_name->lineEdit()->selectAll();
}

void MeasurementsPanel::askForName() {
    goToName();
    m_asks = true;
}

bool MeasurementsPanel::asks() const { return m_asks && m_name->currentText().isEmpty(); }

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
