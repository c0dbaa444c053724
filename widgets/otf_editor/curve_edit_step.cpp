#include "widgets/otf_editor/curve_edit_step.h"

#include <utility>

namespace echolucent {

CurveEditStep::CurveEditStep(OtfEditorState before, OtfEditorState after, const QString& what, int gesture, Apply apply)
    : QUndoCommand(what),
      m_before(std::move(before)),
      m_after(std::move(after)),
      m_gesture(gesture),
      m_apply(std::move(apply)) {}

void CurveEditStep::undo() { m_apply(m_before, activeIfChanged(m_before)); }
void CurveEditStep::redo() { m_apply(m_after, activeIfChanged(m_after)); }

int CurveEditStep::id() const { return m_gesture == 0 ? -1 : 1; }

bool CurveEditStep::mergeWith(const QUndoCommand* other) {
    const auto* later = dynamic_cast<const CurveEditStep*>(other);
    if (!later || later->m_gesture != m_gesture) return false;
    m_after = later->m_after;
    setObsolete(sameEditableCurves(m_before, m_after) && m_before.active == m_after.active);
    return true;
}

std::optional<CurveKind> CurveEditStep::activeIfChanged(const OtfEditorState& side) const {
    if (m_before.active == m_after.active) return std::nullopt;
    return side.active;
}

}  // namespace echolucent
