#include "app/document/document_step.h"

#include <utility>

namespace echolucent {

DocumentStep::DocumentStep(Document before, Document after, const QString& what, int gesture, Restore restore)
    : QUndoCommand(what),
      m_before(std::move(before)),
      m_after(std::move(after)),
      m_gesture(gesture),
      m_restore(std::move(restore)) {}

void DocumentStep::undo() { m_restore(m_before); }
void DocumentStep::redo() { m_restore(m_after); }

int DocumentStep::id() const { return m_gesture == 0 ? -1 : 1; }

bool DocumentStep::mergeWith(const QUndoCommand* other) {
    const auto* later = dynamic_cast<const DocumentStep*>(other);
    if (!later || later->m_gesture != m_gesture || later->text() != text()) return false;
    m_after = later->m_after;
    setObsolete(withShown(m_after, m_before) == m_before);
    return true;
}

}  // namespace echolucent
