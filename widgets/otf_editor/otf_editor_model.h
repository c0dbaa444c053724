// What the editor shows, its edits, its selection, and throttled announcements of the active curve. Knows no widget.
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <optional>

#include "widgets/document/document_model.h"
#include "widgets/otf_editor/otf_editor_state.h"

namespace echolucent {

/// The curves are the document's, and the active one is that of its first pane. Every edit goes to the document as one
/// step. A drag is one step, as are edits that share a gesture (a key or button held down) and successive choices of
/// the active curve. The visibility of curves, the selection and new adaptive curves are no steps. If a step made the
/// manual curve active, its undo makes the former curve active again.
class OtfEditorModel : public QObject {
    Q_OBJECT

public:
    /// Marks edits that belong together. An edit with noGesture stands alone.
    using Gesture = int;
    static constexpr Gesture noGesture = 0;

    /// The document outlives the model.
    explicit OtfEditorModel(DocumentModel& document, QObject* parent = nullptr);

    [[nodiscard]] const OtfEditorState& state() const { return m_state; }

    [[nodiscard]] OpacityCurve activeCurve() const { return renderedCurve(m_state); }
    /// Renders a curve, and draws it.
    void setActive(CurveKind kind);
    void setVisible(CurveKind kind, bool visible);
    /// The newest result of the adaptive method; not undoable.
    void setAdaptiveCurve(const SampledCurve& curve);
    /// Sets the result of the named designer: its upper curve, none if it is not computed yet. The document says
    /// whether the designer's OTF is rendered. Not undoable.
    void setDesign(const std::string& designer, const std::optional<OpacityCurve>& upper);
    void setDesignVisible(bool visible);

    [[nodiscard]] DocumentSteps& steps() { return m_document.steps(); }
    [[nodiscard]] Gesture newGesture() { return ++m_lastGesture; }

    /// Adds a node, clamped into [0,1], selects it and returns its index.
    int addNode(const CurveNode& node);
    /// Adds a node on the curve: halfway to the node after the selected one, or else in the widest gap.
    int addNodeInGap();
    /// Moves a node. It stays between its neighbours and in [0,1].
    void moveNode(int index, const CurveNode& node, Gesture gesture = noGesture);
    /// Removes a node. The last one stays.
    void removeNode(int index);
    [[nodiscard]] bool canRemoveNode() const { return m_state.manual.nodes.size() > 1; }
    /// Replaces the nodes and makes the manual curve active; `what` names the step.
    void replaceManual(const ManualCurve& curve, const QString& what);
    /// Copies the adaptive curve into few nodes (copiedCurveMaxError). If a designer's OTF is rendered, copies its
    /// upper curve. False if there is none yet.
    bool copyIntoNodes();
    /// Clamps the bounds into [0,1] and raises an upper bound below the lower one. Clamps the slope to >= 0; a slope
    /// that is not finite changes nothing.
    void setLinear(const LinearCurve& curve, Gesture gesture = noGesture);
    /// The scale a of the parabolic or quartic curve, clamped to >= 0. A scale that is not finite is ignored.
    void setScale(CurveKind kind, double scale, Gesture gesture = noGesture);
    /// Resets the active curve to CurveSet's default, and resets the adjustment. An adaptive curve or a designer's OTF
    /// stays.
    void resetActiveCurve();

    /// A drag: dragNode shows its change at once, endDrag makes one step of all changes, cancelDrag takes them all
    /// back.
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

    /// True if the manual curve holds work that could be lost: it differs from the curve last saved or opened (before
    /// that, from the one at the beginning) and from every preset.
    [[nodiscard]] bool isManualModified() const { return m_manualModified; }
    void setManualSaved();

signals:
    /// Something must be drawn anew.
    void changed();
    /// The curve to render. Changes during a drag and by held keys are announced at most once in 16 ms. The end of a
    /// drag, and every other change, is announced at once.
    void activeCurveChanged(const echolucent::OpacityCurve& curve);
    void manualEdited(const echolucent::ManualCurve& curve);
    void selectedNodeChanged(int index);

private:
    enum class Announce { now, soon };

    /// Asks the document for a step from the present state to `next`.
    void edit(const OtfEditorState& next, const QString& what, Gesture gesture = noGesture);
    void preview(const OtfEditorState& next);
    void takeFromDocument();
    [[nodiscard]] Document documentOf(const OtfEditorState& next) const;
    void apply(const OtfEditorState& next, Announce announce);
    void announceNow();
    void updateManualModified();
    [[nodiscard]] OtfEditorState withManualActive() const;

    DocumentModel& m_document;
    OtfEditorState m_state;  ///< curves and active curve as the document has them, beside what only the editor shows
    std::optional<OtfEditorState> m_beforeDrag;
    ManualCurve m_savedManual;
    OpacityCurve m_announced;
    QTimer m_announceTimer;
    QElapsedTimer m_sinceAnnounced;
    Announce m_announce = Announce::now;  ///< how a change of the document is announced: soon within a gesture
    bool m_draggedNode = false;           ///< the present change of the document is the drag's own
    Gesture m_lastGesture = noGesture;
    int m_selectedNode = -1;
    bool m_manualModified = false;
};

}  // namespace echolucent
