// The editor's state with undo, selection and the throttled announcement of the active curve; knows no widget.
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <QUndoStack>
#include <functional>
#include <optional>

#include "widgets/otf_editor/otf_editor_state.h"

namespace echolucent {

/// Every change of the manual, linear, parabolic or quartic curve is one step of the undo stack; a drag is one step,
/// and so are edits that share a gesture (a key or button held down). Which curve is active or drawn, the selection
/// and new adaptive curves are not steps; a step that made the manual curve active takes that back too.
class OtfEditorModel : public QObject {
    Q_OBJECT

public:
    /// Marks edits that belong together; noGesture stands alone.
    using Gesture = int;
    static constexpr Gesture noGesture = 0;

    explicit OtfEditorModel(QObject* parent = nullptr);

    [[nodiscard]] const OtfEditorState& state() const { return m_state; }
    /// Replaces everything; forgets the undo steps, and the manual curve counts as saved.
    void setState(const OtfEditorState& state);
    /// What resetActiveCurve goes back to; at first OtfEditorState's defaults.
    void setDefaults(const OtfEditorState& defaults) { m_defaults = defaults; }

    [[nodiscard]] OpacityCurve activeCurve() const { return curveOf(m_state, m_state.active); }
    /// Makes a curve the rendered one, and drawn.
    void setActive(CurveKind kind);
    void setVisible(CurveKind kind, bool visible);
    /// The newest result of the adaptive method; not undoable.
    void setAdaptiveCurve(const SampledCurve& curve);
    /// True while activeCurveChanged is still to come for what the state holds.
    [[nodiscard]] bool announcementPending() const { return m_announceTimer.isActive(); }

    [[nodiscard]] QUndoStack* undoStack() { return &m_undoStack; }
    [[nodiscard]] Gesture newGesture() { return ++m_lastGesture; }

    /// Puts a node among the others (clamped into [0,1]), selects it and returns its index.
    int addNode(const CurveNode& node);
    /// Adds a node on the curve, halfway to the node after the selected one or else in the widest gap.
    int addNodeInGap();
    /// Moves a node, clamped between its neighbours and into [0,1].
    void moveNode(int index, const CurveNode& node, Gesture gesture = noGesture);
    /// Removes a node; the last one stays.
    void removeNode(int index);
    [[nodiscard]] bool canRemoveNode() const { return m_state.manual.nodes.size() > 1; }
    /// Replaces the nodes and makes the manual curve active; `what` names the step.
    void replaceManual(const ManualCurve& curve, const QString& what);
    /// Copies the adaptive curve into few nodes (copiedCurveMaxError); false where there is none yet.
    bool copyAdaptiveIntoNodes();
    /// The bounds are clamped into [0,1] and put in order, the slope to >= 0.
    void setLinear(const LinearCurve& curve, Gesture gesture = noGesture);
    /// The scale a >= 0 of the parabolic or quartic curve.
    void setScale(CurveKind kind, double scale, Gesture gesture = noGesture);
    /// The active curve as setDefaults has it; an adaptive curve stays.
    void resetActiveCurve();

    /// A drag: what dragNode does shows at once, endDrag makes one step of it, cancelDrag takes it back.
    void beginDrag();
    void dragNode(int index, const CurveNode& node);
    void endDrag();
    void cancelDrag();
    [[nodiscard]] bool dragging() const { return m_beforeDrag.has_value(); }
    /// `node` clamped between the neighbours of node `index` and into [0,1].
    [[nodiscard]] CurveNode clampedNode(int index, const CurveNode& node) const;

    /// Index of the selected node, -1 for none.
    [[nodiscard]] int selectedNode() const { return m_selectedNode; }
    void selectNode(int index);

    /// True where the manual curve is neither the one last saved, opened or set, nor a preset: work that could be lost.
    [[nodiscard]] bool isManualModified() const { return m_manualModified; }
    void setManualSaved();

signals:
    /// Something to draw anew.
    void changed();
    /// The curve to render. Previews of a drag and of held keys are announced at most once in 16 ms; what they end
    /// with, and every other change, at once.
    void activeCurveChanged(const echolucent::OpacityCurve& curve);
    void activeChanged(echolucent::CurveKind kind);
    void manualEdited(const echolucent::ManualCurve& curve);
    void manualModifiedChanged(bool modified);
    void selectedNodeChanged(int index);

private:
    enum class Announce { now, soon };

    /// Pushes a step from the present state to `next`.
    void edit(const OtfEditorState& next, const QString& what, Gesture gesture = noGesture);
    void pushStep(const OtfEditorState& before, const OtfEditorState& after, const QString& what, Gesture gesture);
    void applyStep(const OtfEditorState& curves, std::optional<CurveKind> active);
    void apply(const OtfEditorState& next, Announce announce);
    void announceNow();
    void updateManualModified();
    [[nodiscard]] OtfEditorState withManualActive() const;

    OtfEditorState m_state;
    OtfEditorState m_defaults;
    std::optional<OtfEditorState> m_beforeDrag;
    ManualCurve m_savedManual;
    OpacityCurve m_announced;
    QUndoStack m_undoStack;
    QTimer m_announceTimer;
    QElapsedTimer m_sinceAnnounced;
    Announce m_stepAnnounce = Announce::now;  // soon while a step of a gesture is pushed
    Gesture m_lastGesture = noGesture;
    int m_selectedNode = -1;
    bool m_manualModified = false;
};

}  // namespace echolucent
