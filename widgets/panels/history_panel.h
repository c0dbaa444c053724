// The steps of the document, and the snapshots that a person named.
#pragma once

#include <QStringList>
#include <QWidget>

class QLabel;
class QListView;
class QListWidget;
class QStringListModel;
class QToolButton;

namespace echolucent {

class DocumentSteps;

/// Objects: history.list, the steps of the document: the present one is marked, a click goes to another;
/// history.dropped, which says that older steps were dropped; history.keep, history.snapshots, history.rename,
/// history.remove. A click or Enter chooses a snapshot. F2 lets a person type its name. Snapshots are counted from 0.
/// No setter emits a signal.
class HistoryPanel : public QWidget {
    Q_OBJECT

public:
    /// The steps outlive the panel.
    explicit HistoryPanel(DocumentSteps& steps, QWidget* parent = nullptr);

    void setSnapshots(const QStringList& names);
    /// Lets a person type the name of a snapshot.
    void editName(int snapshot);

signals:
    void keepRequested();
    void chosen(int snapshot);
    void renameRequested(int snapshot, const QString& name);
    void removeRequested(int snapshot);

private:
    void showSteps(const DocumentSteps& steps);
    void requestRename(int snapshot, const QString& before, const QString& name);
    void enableButtons();

    QListView* m_steps;
    QStringListModel* m_texts;  ///< the texts of the states: how the document began, then each step
    QLabel* m_dropped;
    QListWidget* m_snapshots;
    QStringList m_names;  ///< of the snapshots, as they were set
    QLabel* m_none;
    QToolButton *m_rename, *m_remove;
};

}  // namespace echolucent
