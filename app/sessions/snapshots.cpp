#include "app/sessions/snapshots.h"

#include <utility>

namespace echolucent {

namespace {

QString sentenceOnName(const std::string& name) {
    const std::string problem = problemOfSnapshotName(name);
    return problem.empty() ? QString() : Snapshots::tr("A snapshot's name %1.").arg(QString::fromStdString(problem));
}

}  // namespace

void Snapshots::begin(std::vector<Snapshot> list) {
    m_list = std::move(list);
    emit changed();
}

QString Snapshots::keep(const QString& name, const Document& document) {
    const std::string wanted = name.trimmed().toStdString();
    if (QString problem = sentenceOnName(wanted); !problem.isEmpty()) return problem;
    if (m_list.size() >= mostSnapshots)
        return tr("A session holds at most %1 snapshots. Remove one first.").arg(mostSnapshots);
    m_list.push_back({wanted, document});
    emit changed();
    return {};
}

QString Snapshots::rename(int snapshot, const QString& name) {
    const std::string wanted = name.trimmed().toStdString();
    if (QString problem = sentenceOnName(wanted); !problem.isEmpty()) return problem;
    m_list.at(static_cast<std::size_t>(snapshot)).name = wanted;
    emit changed();
    return {};
}

void Snapshots::remove(int snapshot) {
    (void)m_list.at(static_cast<std::size_t>(snapshot));
    m_list.erase(m_list.begin() + snapshot);
    emit changed();
}

}  // namespace echolucent
