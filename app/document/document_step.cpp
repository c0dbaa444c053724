#include "app/document/document_step.h"

#include <utility>

namespace echolucent {

DocumentStep::DocumentStep(DocumentModel& model, Document before, Document after, const QString& what,
                           DocumentModel::Gesture gesture)
    : QUndoCommand(what), m_model(model), m_before(std::move(before)), m_after(std::move(after)), m_gesture(gesture) {}

void DocumentStep::undo() { m_model.restore(m_before); }
void DocumentStep::redo() { m_model.restore(m_after); }

int DocumentStep::id() const { return m_gesture == DocumentModel::noGesture ? -1 : 1; }

bool DocumentStep::mergeWith(const QUndoCommand* other) {
    const auto* later = dynamic_cast<const DocumentStep*>(other);
    if (!later || later->m_gesture != m_gesture || later->text() != text()) return false;
    m_after = later->m_after;
    setObsolete(withShown(m_after, m_before) == m_before);
    return true;
}

}  // namespace echolucent
