#include "widgets/otf_editor/node_table.h"

#include <QHeaderView>
#include <QKeyEvent>
#include <algorithm>
#include <utility>

namespace echolucent {

NodeTable::NodeTable(OtfEditorModel& model, QWidget* parent) : QTableView(parent), m_editorModel(model), m_rows(model) {
    setObjectName("otfEditor.nodeTable");
    setAccessibleName(tr("Nodes of the manual curve"));
    setModel(&m_rows);
    setSelectionMode(QAbstractItemView::SingleSelection);
    setSelectionBehavior(QAbstractItemView::SelectItems);
    setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
    setTabKeyNavigation(false);  // Tab goes to the next control, arrows move inside
    setWordWrap(false);
    horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    horizontalHeader()->setHighlightSections(false);
    verticalHeader()->setHighlightSections(false);
    verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    connect(&m_rows, &NodeTableModel::refused, this, &NodeTable::refused);
    connect(&m_rows, &QAbstractItemModel::modelReset, this, &NodeTable::showSelectedNode);
    connect(&m_editorModel, &OtfEditorModel::selectedNodeChanged, this, &NodeTable::showSelectedNode);
}

void NodeTable::fitRows(int shown) {
    const int row = fontMetrics().height() + 8;
    verticalHeader()->setDefaultSectionSize(row);
    setFixedHeight((shown + 1) * row + 6);
}

void NodeTable::setValueWindow(const ValueWindow& window) {
    m_rows.setValueWindow(window);
    setColumnHidden(NodeTableModel::valueColumn, window.isNormalised());
}

/// Ignores typed digits: they must not edit a number that nobody opened, nor jump to another row.
void NodeTable::keyboardSearch(const QString&) {}

void NodeTable::keyPressEvent(QKeyEvent* event) {
    const bool typing = state() == QAbstractItemView::EditingState;
    if (!typing && event->key() == Qt::Key_Delete && currentIndex().isValid()) {
        m_editorModel.removeNode(currentIndex().row());
        return;
    }
    const bool enters = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    if (!typing && enters && currentIndex().isValid()) {
        edit(currentIndex());
        return;
    }
    QTableView::keyPressEvent(event);
}

void NodeTable::currentChanged(const QModelIndex& current, const QModelIndex& previous) {
    QTableView::currentChanged(current, previous);
    if (!m_following && current.isValid()) m_editorModel.selectNode(current.row());
}

void NodeTable::showSelectedNode() {
    const bool outer = std::exchange(m_following, true);
    const int node = m_editorModel.selectedNode();
    if (node < 0 || node >= m_rows.rowCount()) {
        setCurrentIndex({});
        clearSelection();
    } else if (currentIndex().row() != node) {
        setCurrentIndex(m_rows.index(node, std::max(0, currentIndex().column())));
    }
    m_following = outer;
}

}  // namespace echolucent
