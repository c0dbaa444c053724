// One step of the OTF editor's undo stack.
#pragma once

#include <QUndoCommand>
#include <functional>
#include <optional>

#include "widgets/otf_editor/otf_editor_state.h"

namespace echolucent {

/// The editable curves before and after; steps of one gesture become one.
class CurveEditStep : public QUndoCommand {
public:
    /// Puts the editable curves into the model, and the active curve where the step changed it.
    using Apply = std::function<void(const OtfEditorState& curves, std::optional<CurveKind> active)>;

    /// `gesture` 0: stands alone.
    CurveEditStep(OtfEditorState before, OtfEditorState after, const QString& what, int gesture, Apply apply);

    void undo() override;
    void redo() override;
    [[nodiscard]] int id() const override;
    bool mergeWith(const QUndoCommand* other) override;

private:
    [[nodiscard]] std::optional<CurveKind> activeIfChanged(const OtfEditorState& side) const;

    OtfEditorState m_before;
    OtfEditorState m_after;
    int m_gesture;
    Apply m_apply;
};

}  // namespace echolucent
