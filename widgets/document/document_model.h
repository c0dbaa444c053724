// The document of the window: its one value, one undo stack for all changes, and one signal a part.
#pragma once

#include <QObject>
#include <QString>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "processing/document/document.h"
#include "widgets/document/document_steps.h"

namespace echolucent {

/// Everything changes through edit() or preview(). Every change of edit() is a step that can be undone: of curves,
/// poses, cuts, looks, parameters alike. The shown phase and the motion's frame are no steps, and an undo does not
/// change them. Results computed from the document are kept elsewhere.
///
///              preview()                 preview()
///   [at rest] -----------> [previewing] ---------+    commitPreview(), or edit(): one step for all previews
///       ^                     |     ^            |    cancelPreview(), undo, redo: as before the first preview
///       +---------------------+     +------------+
class DocumentModel : public QObject {
    Q_OBJECT

public:
    /// Edits of one gesture (a drag, a burst of the wheel, a key held down) with one name become one step.
    using Gesture = int;
    static constexpr Gesture noGesture = 0;

    /// The steps keep at most `mostBytes` bytes, but always the newest step.
    explicit DocumentModel(QObject* parent = nullptr, std::size_t mostBytes = DocumentSteps::mostBytesKept);

    [[nodiscard]] const Document& document() const { return m_document; }
    [[nodiscard]] DocumentSteps& steps() { return m_steps; }

    /// Says which gesture a hand makes now; noGesture if none. Without a Hand, gesture() is noGesture.
    using Hand = std::function<Gesture()>;
    void setHand(Hand hand) { m_hand = std::move(hand); }
    [[nodiscard]] Gesture gesture() const { return m_hand ? m_hand() : noGesture; }

    /// Makes `wanted` the document, as one step named `what`, of the hand's gesture or the given one. A preview that
    /// goes on becomes part of this step. If `wanted` differs only in the shown phase and frame, there is no step.
    void edit(const Document& wanted, const QString& what) { edit(wanted, what, gesture()); }
    void edit(const Document& wanted, const QString& what, Gesture gesture);
    /// edit() with the shown phase and the motion's frame of `wanted`: this step's undo and redo bring back both too.
    void editWithFrame(const Document& wanted, const QString& what);
    /// edit() with the present document as changed by how(Document&).
    template <typename Change>
    void change(const QString& what, Change&& how) {
        Document next = m_document;
        std::forward<Change>(how)(next);
        edit(next, what);
    }
    /// Calls show(const Document&) now, and after each `signal` while the receiver lives.
    template <typename Signal, typename Show>
    void bind(Signal signal, const QObject* receiver, Show show) const {
        connect(this, signal, receiver, [this, show] { show(m_document); });
        show(m_document);
    }

    /// Shows `wanted` without a step, while a drag goes on.
    void preview(const Document& wanted, const QString& what);
    void commitPreview();
    void cancelPreview();
    /// preview() while a drag goes on, else edit().
    void take(const Document& wanted, const QString& what, bool dragging);
    /// take() for a camera that the hand has moved to `moved`. The motion's angle becomes 0, so a motion starts anew
    /// from where the person left the camera.
    void moveCamera(const Pose& moved, bool dragging);
    [[nodiscard]] bool previewing() const { return m_beforePreview.has_value(); }

    /// Shows a phase (counted from 0) of the study. No step.
    void showPhase(int phase);
    /// Shows the frame of the motion at an angle in degrees, and a phase, at once. No step.
    void showFrame(double degrees, int phase);

    /// Adds panes to a document of one pane, only to look at them. This is no step. Neither the steps nor ownDocument()
    /// hold these panes, and an undo leaves them where they are. They become the document's own once an edit changes
    /// one of them or how they are compared. std::invalid_argument if the document has several panes.
    void lookAtPanes(const std::vector<Pane>& added);
    /// Takes the panes of lookAtPanes() away if nobody has changed them. This is no step.
    void endLookAtPanes();
    /// The document as a person has set it: without panes that are only looked at.
    [[nodiscard]] Document ownDocument() const { return withoutLook(m_document); }

    /// Notes the checksum of the document's study. This is no step, and emits only changed(). Edits, undo and redo keep
    /// the checksum. std::invalid_argument if `study` is another study than the document's.
    void noteChecksum(const StudyReference& study);
    /// Begins another document, and forgets the steps.
    void begin(const Document& document);
    /// ownDocument() and the steps that led to it, to come back to them.
    struct Kept {
        Document document;
        std::shared_ptr<const DocumentSteps::Kept> steps;
    };
    [[nodiscard]] Kept keep() const { return {ownDocument(), m_steps.keep()}; }
    /// begin() with a document that keep() gave, and with its steps.
    void comeBack(const Kept& kept);

signals:
    void studyChanged();
    void beamChanged();
    void poseChanged();
    /// The tube cores look from another side.
    void sideChanged();
    void frontChanged();
    void lookChanged();
    void boxChanged();
    void planesChanged();
    void strokesChanged();
    /// Panes were added or removed, or are classified with something else.
    void panesChanged();
    void measurementsChanged();
    void curvesChanged();
    void methodChanged();
    void motionChanged();
    /// Another phase is shown.
    void phaseChanged();
    /// Another frame of the motion is shown.
    void motionAngleChanged();
    /// Emitted last, after the signals of all parts that a change touched.
    void changed();

private:
    /// The function that undo and redo call.
    void restore(const Document& document, bool withFrame);
    void makeStep(const Document& wanted, const QString& what, Gesture gesture, bool setsFrame);
    void set(Document next);
    /// What lookAtPanes() has added, and how the panes were compared then.
    struct LookedAt {
        std::vector<Pane> added;
        Comparison comparison;
    };
    /// The document without the panes of the look, if it has just these beside its first one.
    [[nodiscard]] Document withoutLook(Document document) const;
    /// The document with the panes of the look, if it has one pane. From then on the look is of its comparison.
    [[nodiscard]] Document withLook(Document document);
    /// `document`, with the present document's study reference if both name the same study: only the present one may
    /// know the checksum.
    [[nodiscard]] Document keepingChecksum(Document document) const;
    /// keepingChecksum(), sharing lists with the present document, or with the document before the preview if there is
    /// one.
    [[nodiscard]] Document keptOf(Document document) const;

    Hand m_hand;
    Document m_document;
    std::optional<LookedAt> m_look;  ///< while panes are looked at
    std::optional<Document> m_beforePreview;
    QString m_previewed;  ///< name of the step that the preview becomes
    DocumentSteps m_steps;
};

}  // namespace echolucent
