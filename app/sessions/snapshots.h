// The snapshots of the open session.
#pragma once

#include <QObject>
#include <QString>
#include <vector>

#include "processing/document/saved_session.h"

namespace echolucent {

/// Documents with names, oldest first, counted from 0. They stand beside the document's undo stack: keeping, renaming
/// and removing one is no step.
class Snapshots : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

    [[nodiscard]] const std::vector<Snapshot>& list() const { return m_list; }
    /// Replaces all snapshots by those of another session.
    void begin(std::vector<Snapshot> list);
    /// Keeps a document under a name. Returns an empty text, or a sentence: why it was not kept.
    QString keep(const QString& name, const Document& document);
    /// Returns an empty text, or a sentence: why the snapshot keeps its name.
    QString rename(int snapshot, const QString& name);
    void remove(int snapshot);

signals:
    void changed();

private:
    std::vector<Snapshot> m_list;
};

}  // namespace echolucent
