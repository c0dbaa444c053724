// The table of exact node values.
#pragma once

#include <QTableView>

#include "widgets/otf_editor/node_table_model.h"

namespace echolucent {

/// The table's current row is the editor's selected node. Delete removes the node. A double click, Return or F2 lets a
/// person type a number; digits do nothing before that.
class NodeTable : public QTableView {
    Q_OBJECT

public:
    explicit NodeTable(OtfEditorModel& model, QWidget* parent = nullptr);

    /// Makes the table as high as its heading and so many rows.
    void fitRows(int shown);
    /// The file's values at intensities 0 and 1. If they are 0 and 1, their column is hidden.
    void setValueWindow(const ValueWindow& window);

signals:
    /// Says why an input was refused.
    void refused(const QString& reason);

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void keyboardSearch(const QString& search) override;
    void currentChanged(const QModelIndex& current, const QModelIndex& previous) override;

private:
    void showSelectedNode();

    OtfEditorModel& m_editorModel;
    NodeTableModel m_rows;
    bool m_following = false;  // while the selection comes from the model
};

}  // namespace echolucent
