#include "widgets/panels/history_panel.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QListView>
#include <QListWidget>
#include <QPushButton>
#include <QSignalBlocker>
#include <QStringListModel>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

#include "widgets/controls/panel_controls.h"
#include "widgets/document/document_steps.h"

namespace echolucent {

HistoryPanel::HistoryPanel(DocumentSteps& steps, QWidget* parent)
    : QWidget(parent),
      m_steps(new QListView(this)),
      m_texts(new QStringListModel(this)),
      m_dropped(new QLabel(this)),
      m_snapshots(new QListWidget(this)),
      m_none(new QLabel(tr("A snapshot keeps what is set now under a name. The session file holds it."), this)),
      m_rename(new QToolButton(this)),
      m_remove(new QToolButton(this)) {
    m_steps->setObjectName("history.list");
    m_steps->setAccessibleName(tr("History"));
    m_steps->setToolTip(
        tr("What was changed since the study was opened, step by step. A click goes to one of the steps"));
    m_steps->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_steps->setModel(m_texts);
    m_dropped->setObjectName("history.dropped");
    m_dropped->setAccessibleName(tr("Steps that were dropped"));
    m_dropped->setWordWrap(true);
    m_dropped->hide();
    m_snapshots->setObjectName("history.snapshots");
    m_snapshots->setAccessibleName(tr("Snapshots"));
    m_snapshots->setToolTip(tr("A click brings back what was kept under this name"));
    m_snapshots->setEditTriggers(QAbstractItemView::EditKeyPressed);
    m_none->setWordWrap(true);
    auto* keep = new QPushButton(tr("Keep as snapshot"), this);
    keep->setObjectName("history.keep");
    keep->setAccessibleName(keep->text());
    keep->setToolTip(tr("Keeps all that is set now under a name, so that you can come back to it later"));
    m_rename->setObjectName("history.rename");
    m_rename->setText(tr("Rename"));
    m_rename->setToolTip(tr("Gives the selected snapshot another name"));
    m_remove->setObjectName("history.remove");
    m_remove->setText(tr("Remove"));
    m_remove->setToolTip(tr("Removes the selected snapshot"));
    for (QToolButton* button : {m_rename, m_remove}) button->setAccessibleName(button->text());

    auto* column = new QVBoxLayout(this);
    auto* stepsTitle = new QLabel(tr("History"), this);
    auto* snapshotsTitle = new QLabel(tr("Snapshots"), this);
    column->addWidget(stepsTitle);
    column->addWidget(m_steps, 3);
    column->addWidget(m_dropped);
    column->addWidget(snapshotsTitle);
    column->addWidget(m_none);
    column->addWidget(m_snapshots, 2);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(keep);
    buttons->addStretch(1);
    buttons->addWidget(m_rename);
    buttons->addWidget(m_remove);
    column->addLayout(buttons);

    connect(keep, &QPushButton::clicked, this, &HistoryPanel::keepRequested);
    const auto choose = [this](QListWidgetItem* item) { emit chosen(m_snapshots->row(item)); };
    connect(m_snapshots, &QListWidget::itemClicked, this, choose);
    connect(m_snapshots, &QListWidget::itemActivated, this, choose);
    connect(m_snapshots, &QListWidget::currentRowChanged, this, &HistoryPanel::enableButtons);
    connect(m_snapshots, &QListWidget::itemChanged, this, [this](QListWidgetItem* item) {
        const int row = m_snapshots->row(item);
        // Ask later: the answer makes the list anew, but here the list's editor is still at work. The item may be gone
        // by then, so pass its row and its names.
        QMetaObject::invokeMethod(
            this, [this, row, before = m_names.at(row), name = item->text()] { requestRename(row, before, name); },
            Qt::QueuedConnection);
    });
    connect(m_rename, &QToolButton::clicked, this, [this] { editName(m_snapshots->currentRow()); });
    connect(m_remove, &QToolButton::clicked, this, [this] { emit removeRequested(m_snapshots->currentRow()); });
    setSnapshots({});
    connect(&steps, &DocumentSteps::changed, this, [this, &steps] { showSteps(steps); });
    connect(m_steps->selectionModel(), &QItemSelectionModel::currentChanged, &steps, [&steps](const QModelIndex& row) {
        if (row.isValid()) steps.setIndex(row.row());
    });
    showSteps(steps);
}

void HistoryPanel::showSteps(const DocumentSteps& steps) {
    const bool isWhole = steps.dropped() == 0;
    QStringList texts{isWhole ? tr("as opened") : tr("before these steps")};
    for (int step = 0; step < steps.count(); ++step) texts << steps.text(step);
    m_texts->setStringList(texts);
    m_steps->setCurrentIndex(m_texts->index(steps.index()));
    m_dropped->setText(tr("Older steps were dropped: undo keeps %1 MB").arg(steps.mostBytes() / 1'000'000));
    m_dropped->setVisible(!isWhole);
}

void HistoryPanel::setSnapshots(const QStringList& names) {
    const QSignalBlocker quiet(m_snapshots);
    m_names = names;
    const int current = m_snapshots->currentRow();
    m_snapshots->clear();
    m_snapshots->addItems(names);
    for (int i = 0; i < m_snapshots->count(); ++i) {
        QListWidgetItem* item = m_snapshots->item(i);
        item->setFlags(item->flags() | Qt::ItemIsEditable);
        item->setToolTip(literalToolTip(item->text()));
    }
    m_snapshots->setCurrentRow(std::min(current, m_snapshots->count() - 1));
    m_none->setVisible(names.isEmpty());
    m_snapshots->setVisible(!names.isEmpty());
    enableButtons();
}

/// The list may have changed since the person typed the name.
void HistoryPanel::requestRename(int snapshot, const QString& before, const QString& name) {
    if (snapshot < m_names.size() && m_names.at(snapshot) == before) emit renameRequested(snapshot, name);
}

void HistoryPanel::editName(int snapshot) {
    if (QListWidgetItem* item = m_snapshots->item(snapshot)) {
        m_snapshots->setCurrentItem(item);
        m_snapshots->editItem(item);
    }
}

void HistoryPanel::enableButtons() {
    const bool any = m_snapshots->currentRow() >= 0;
    for (QToolButton* button : {m_rename, m_remove}) enableOrSayWhy(*button, any, tr("No snapshot is selected."));
}

}  // namespace echolucent
