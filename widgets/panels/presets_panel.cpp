#include "widgets/panels/presets_panel.h"

#include <QAction>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QMenu>
#include <QPushButton>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

#include "widgets/controls/panel_controls.h"
#include "widgets/larger_letters.h"

namespace echolucent {

namespace {

constexpr int gap = 8, linesOfName = 2;

/// Stands in the gallery for a picture that is not there yet.
QPixmap darkPicture() {
    QPixmap dark(PresetsPanel::pictureWidth, PresetsPanel::pictureHeight);
    dark.fill(Qt::black);
    return dark;
}

}  // namespace

PresetsPanel::PresetsPanel(QWidget* parent) : QWidget(parent) {
    setObjectName("presets");
    setAccessibleName(tr("Presets"));
    m_open = named(new QToolButton, "presets.open", tr("Presets"),
                   tr("Shows what each preset makes of this volume, as small pictures"));
    m_open->setText(tr("Presets"));
    m_open->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_open->setArrowType(Qt::RightArrow);
    m_open->setCheckable(true);
    m_open->setFocusPolicy(Qt::StrongFocus);
    m_currentName = secondaryLabel();
    m_currentName->setObjectName("presets.current");
    m_currentName->setAccessibleName(tr("Preset that is shown"));
    m_gallery = new QWidget;
    createList();
    auto* save = named(new QPushButton(tr("Save as preset")), "presets.save", tr("Save as preset"),
                       tr("Keeps curve, look and mode under a name of yours"));
    connect(save, &QPushButton::clicked, this, &PresetsPanel::saveRequested);
    createActions();

    auto* header = new QHBoxLayout;
    header->addWidget(m_open);
    header->addWidget(m_currentName, 1);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(save, 1);
    buttons->addWidget(m_more, 1);
    auto* gallery = new QVBoxLayout(m_gallery);
    gallery->setContentsMargins(0, 0, 0, 0);
    gallery->addWidget(m_list);
    gallery->addLayout(buttons);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(9, 9, 9, 0);
    layout->addLayout(header);
    layout->addWidget(m_gallery);
    m_gallery->hide();
    connect(m_open, &QToolButton::toggled, this, [this](bool open) {
        m_open->setArrowType(open ? Qt::DownArrow : Qt::RightArrow);
        m_gallery->setVisible(open);
        fitHeight();
        emit seenChanged(open && isVisible());
    });
}

void PresetsPanel::createList() {
    m_list = named(new QListWidget, "presets.list", tr("Presets"));
    m_list->setViewMode(QListView::IconMode);
    m_list->setMovement(QListView::Static);
    m_list->setResizeMode(QListView::Adjust);
    m_list->setWordWrap(true);
    m_list->setTextElideMode(Qt::ElideRight);
    m_list->setIconSize({pictureWidth, pictureHeight});
    m_list->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_list->setFrameShape(QFrame::NoFrame);
    // The gallery is as high as its rows, and the panel around it scrolls.
    m_list->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    wheelNeedsFocus(m_list);
    m_list->viewport()->installEventFilter(this);
    connect(m_list, &QListWidget::itemClicked, this, [this](QListWidgetItem* item) { emit chosen(m_list->row(item)); });
    connect(m_list, &QListWidget::itemActivated, this,
            [this](QListWidgetItem* item) { emit chosen(m_list->row(item)); });
    connect(m_list, &QListWidget::currentRowChanged, this, &PresetsPanel::enableActions);
    connect(m_list, &QListWidget::itemChanged, this, [this](QListWidgetItem* item) {
        const int preset = m_list->row(item);
        if (item->text() != nameOf(preset)) emit renameRequested(preset, item->text());
    });
}

void PresetsPanel::createActions() {
    m_more = named(new QToolButton, "presets.more", tr("Manage presets"),
                   tr("Rename, remove and export the selected preset, or import presets"));
    m_more->setText(tr("Manage"));
    m_more->setPopupMode(QToolButton::InstantPopup);
    m_more->setFocusPolicy(Qt::StrongFocus);
    m_more->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    auto* menu = named(new QMenu(m_more), "presets.more.menu", tr("Manage presets"));
    menu->setToolTipsVisible(true);
    const auto add = [this, menu](const QString& text, const QString& name, auto&& run) {
        QAction* action = menu->addAction(text);
        action->setObjectName(name);
        connect(action, &QAction::triggered, this, run);
        return action;
    };
    m_rename = add(tr("Rename"), "presets.rename", [this] { editName(selected()); });
    m_remove = add(tr("Remove"), "presets.remove", [this] { emit removeRequested(selected()); });
    m_export = add(tr("Export…"), "presets.export", [this] { emit exportRequested(selected()); });
    add(tr("Import…"), "presets.import", [this] { emit importRequested(); });
    m_more->setMenu(menu);
    m_list->setContextMenuPolicy(Qt::CustomContextMenu);
    connect(m_list, &QListWidget::customContextMenuRequested, menu,
            [this, menu](const QPoint& place) { menu->popup(m_list->viewport()->mapToGlobal(place)); });
    enableActions();
}

void PresetsPanel::setPresets(const QList<PresetEntry>& presets) {
    const int kept = selected();
    m_presets = presets;
    {
        const QSignalBlocker blocker(m_list);
        m_list->clear();
        for (const PresetEntry& preset : presets) {
            auto* item = new QListWidgetItem(QIcon(darkPicture()), preset.name, m_list);
            item->setToolTip(preset.contents);
            item->setTextAlignment(Qt::AlignHCenter | Qt::AlignTop);
            if (preset.own) item->setFlags(item->flags() | Qt::ItemIsEditable);
        }
        m_list->setCurrentRow(std::min(kept, static_cast<int>(presets.size()) - 1));
    }
    m_current = -1;
    showCurrent();
    enableActions();
    fitHeight();
}

void PresetsPanel::setPicture(int preset, const QImage& picture) {
    const QSignalBlocker blocker(m_list);
    m_list->item(preset)->setIcon(QIcon(picture.isNull() ? darkPicture() : QPixmap::fromImage(picture)));
}

void PresetsPanel::setCurrent(int preset) {
    if (preset == m_current) return;
    m_current = preset;
    showCurrent();
}

void PresetsPanel::showCurrent() {
    const QSignalBlocker blocker(m_list);
    for (int row = 0; row < m_list->count(); ++row) {
        QFont font;  // its size is the list's
        font.setBold(row == m_current);
        m_list->item(row)->setFont(font);
    }
    m_currentName->setText(m_current < 0 ? tr("changed") : nameOf(m_current));
}

bool PresetsPanel::isOpen() const { return m_open->isChecked(); }
void PresetsPanel::setOpen(bool open) { m_open->setChecked(open); }

void PresetsPanel::editName(int preset) {
    QListWidgetItem* item = m_list->item(preset);
    m_list->setCurrentItem(item);
    m_list->setFocus();
    m_list->editItem(item);
}

void PresetsPanel::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    fitHeight();
    emit seenChanged(isOpen());
}

void PresetsPanel::hideEvent(QHideEvent* event) {
    QWidget::hideEvent(event);
    emit seenChanged(false);
}

bool PresetsPanel::eventFilter(QObject* watched, QEvent* event) {
    if (watched == m_list->viewport() && event->type() == QEvent::Resize) fitHeight();
    if (watched == m_list->viewport() && event->type() == QEvent::FontChange)
        QMetaObject::invokeMethod(this, &PresetsPanel::fitHeight, Qt::QueuedConnection);
    return QWidget::eventFilter(watched, event);
}

/// Fits as many columns as there is room for, and the height to the rows.
void PresetsPanel::fitHeight() {
    const int nameHeight = linesOfName * m_list->fontMetrics().lineSpacing();
    const int columns = std::max(1, m_list->viewport()->width() / inLettersOf(*m_list, pictureWidth + gap));
    const QSize cell((m_list->viewport()->width() - 1) / columns, pictureHeight + nameHeight + gap);
    if (m_list->gridSize() != cell) m_list->setGridSize(cell);
    const int rows = (m_list->count() + columns - 1) / columns;
    m_list->setFixedHeight(rows * cell.height() + 4);
}

void PresetsPanel::enableActions() {
    const int preset = selected();
    const bool own = preset >= 0 && m_presets[preset].own;
    const QString none = tr("No preset is selected.");
    const QString builtIn = preset < 0 ? none : tr("This preset belongs to the program.");
    enableOrSayWhy(*m_rename, own, builtIn);
    enableOrSayWhy(*m_remove, own, builtIn);
    enableOrSayWhy(*m_export, preset >= 0, none);
}

int PresetsPanel::selected() const {
    const int row = m_list->currentRow();
    return row < m_presets.size() ? row : -1;
}

QString PresetsPanel::nameOf(int preset) const { return m_presets[preset].name; }

}  // namespace echolucent
