// One step of the document's undo stack.
#pragma once

#include <QUndoCommand>

#include "app/document/document_model.h"

namespace echolucent {

/// The document before and after; steps of one gesture and name become one.
class DocumentStep : public QUndoCommand {
public:
    DocumentStep(DocumentModel& model, Document before, Document after, const QString& what,
                 DocumentModel::Gesture gesture);

    void undo() override;
    void redo() override;
    [[nodiscard]] int id() const override;
    bool mergeWith(const QUndoCommand* other) override;

private:
    DocumentModel& m_model;
    Document m_before;
    Document m_after;
    DocumentModel::Gesture m_gesture;
};

}  // namespace echolucent
