#include "app/sessions/history_controls.h"

#include "widgets/controls/message_bar.h"
#include "widgets/panels/history_panel.h"

namespace echolucent {

namespace {
constexpr const char* snapshotTopic = "snapshots";
}  // namespace

HistoryControls::HistoryControls(DocumentModel& model, Snapshots& snapshots, HistoryPanel& panel, MessageBar& messages)
    : m_model(model), m_snapshots(snapshots), m_panel(panel), m_messages(messages) {
    connect(&m_panel, &HistoryPanel::keepRequested, this, &HistoryControls::keep);
    connect(&m_panel, &HistoryPanel::chosen, this, &HistoryControls::choose);
    connect(&m_panel, &HistoryPanel::removeRequested, this, &HistoryControls::remove);
    connect(&m_panel, &HistoryPanel::renameRequested, this, [this](int snapshot, const QString& name) {
        const QString problem = m_snapshots.rename(snapshot, name);
        if (problem.isEmpty()) return;
        m_messages.showMessage(MessageKind::warning, problem, MessageEnd::withStudy(snapshotTopic));
        show();
    });
    connect(&m_snapshots, &Snapshots::changed, this, [this] {
        m_messages.takeBack(snapshotTopic);
        show();
    });
    show();
}

void HistoryControls::show() {
    QStringList names;
    for (const Snapshot& snapshot : m_snapshots.list()) names << QString::fromStdString(snapshot.name);
    m_panel.setSnapshots(names);
}

void HistoryControls::keep() {
    const int count = static_cast<int>(m_snapshots.list().size());
    const QString problem = m_snapshots.keep(tr("Snapshot %1").arg(count + 1), m_model.ownDocument());
    if (problem.isEmpty())
        m_panel.editName(count);
    else
        m_messages.showMessage(MessageKind::warning, problem, MessageEnd::withStudy(snapshotTopic));
}

void HistoryControls::choose(int snapshot) {
    const Snapshot chosen = m_snapshots.list().at(static_cast<std::size_t>(snapshot));
    m_model.editWithFrame(chosen.document, tr("snapshot \"%1\"").arg(QString::fromStdString(chosen.name)));
}

void HistoryControls::remove(int snapshot) {
    const Snapshot removed = m_snapshots.list().at(static_cast<std::size_t>(snapshot));
    m_snapshots.remove(snapshot);
    m_messages.showMessage(
        MessageKind::info, tr("The snapshot \"%1\" was removed.").arg(QString::fromStdString(removed.name)),
        MessageEnd::soon(snapshotTopic),
        {{tr("Bring back"),
          [this, removed] { (void)m_snapshots.keep(QString::fromStdString(removed.name), removed.document); }}});
}

}  // namespace echolucent
