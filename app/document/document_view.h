// A 3D view that shows one view of the document.
#pragma once

#include <QObject>
#include <memory>
#include <optional>

#include "processing/classification.h"
#include "widgets/document/document_model.h"
#include "widgets/hand_gesture.h"

namespace echolucent {

class Volume;
class VolumeViewWidget;

/// Shows the scene and the curve of the first pane in a widget, and makes steps of what the hand does there. Several of
/// them show one document: turning one turns all.
class DocumentView : public QObject {
    Q_OBJECT

public:
    /// All of them must outlive this.
    DocumentView(DocumentModel& model, HandGesture& hand, VolumeViewWidget& widget, QObject* parent = nullptr);

    /// The volume of the view's phase; takes the newest of the document with it, and ends a hold().
    /// Pointed values are those of `measured`, the voxels that were read.
    /// A held view whose design is not computed yet is held until it is.
    void showVolume(const std::shared_ptr<const Volume>& volume, const std::shared_ptr<const Volume>& measured);
    /// The widget goes on showing what it shows, until the next volume: a picture is never made of one study's voxels
    /// and another's values.
    void hold();
    [[nodiscard]] bool held() const { return m_held; }
    /// Takes the adaptive curve of the phase that is shown.
    void setAdaptiveCurve(const SampledCurve& curve) { m_adaptive = curve; }
    /// Takes what the designer of the view made, and shows it where the view has a design. Until the first one is
    /// there, the picture stays as it was.
    void setDesigned(const Classification& designed);
    /// There will be no design for now: a view that is held for it shows its volume without.
    void doWithoutDesign();
    [[nodiscard]] const SampledCurve& adaptiveCurve() const { return m_adaptive; }

public slots:
    /// From where the document looks in the present frame of the motion. Poses and cuts that change are shown by
    /// themselves; a frame is shown when its OTF is there.
    void showPose();
    /// Shows the view's curve. To be called as often as a person is to see it change.
    void showCurve();

signals:
    /// A held view waits with its volume until its design is there.
    void designAwaited();
    /// The hand has moved the camera.
    void cameraMoved();

private:
    void showLook();
    void leaveDesign();
    [[nodiscard]] bool awaitsDesign() const;
    void takePose();
    void takeLight();
    void take(const Document& next, const QString& what);

    DocumentModel& m_model;
    HandGesture& m_hand;
    VolumeViewWidget& m_widget;
    /// Volumes as showVolume() takes them.
    struct Volumes {
        std::shared_ptr<const Volume> shown, measured;
    };
    SampledCurve m_adaptive;
    std::optional<Classification> m_designed;
    std::optional<Volumes> m_waiting;  ///< for the design of a view that is held
    bool m_held = false;
};

}  // namespace echolucent
