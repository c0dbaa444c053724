// One step of the document's undo stack.
#pragma once

#include <QUndoCommand>
#include <functional>

#include "processing/document/document.h"

namespace echolucent {

/// The document before and after; steps of one gesture and name become one.
class DocumentStep : public QUndoCommand {
public:
    /// Makes a document the present one.
    using Restore = std::function<void(const Document& document)>;

    /// A step of gesture 0 stands alone.
    DocumentStep(Document before, Document after, const QString& what, int gesture, Restore restore);

    void undo() override;
    void redo() override;
    [[nodiscard]] int id() const override;
    bool mergeWith(const QUndoCommand* other) override;

private:
    Document m_before;
    Document m_after;
    int m_gesture;
    Restore m_restore;
};

}  // namespace echolucent
