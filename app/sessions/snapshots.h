// The snapshots of the session that is open.
#pragma once

#include <QObject>
#include <QString>
#include <vector>

#include "processing/document/saved_session.h"

namespace echolucent {

/// Documents under names, oldest first, counted from 0. They stand beside the document's undo stack: keeping, renaming
/// and removing one is no step.
class Snapshots : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

    [[nodiscard]] const std::vector<Snapshot>& list() const { return m_list; }
    /// Another session is open, with these.
    void begin(std::vector<Snapshot> list);
    /// Keeps a document under a name. An empty text, or why it was not kept, as a sentence.
    QString keep(const QString& name, const Document& document);
    /// An empty text, or why the snapshot keeps its name, as a sentence.
    QString rename(int snapshot, const QString& name);
    void remove(int snapshot);

signals:
    void changed();

private:
    std::vector<Snapshot> m_list;
};

}  // namespace echolucent
