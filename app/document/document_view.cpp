#include "app/document/document_view.h"

#include <utility>

#include "app/document/camera_step.h"
#include "processing/document/view_caster.h"
#include "widgets/volume_view/volume_view_widget.h"

namespace echolucent {

DocumentView::DocumentView(DocumentModel& model, HandGesture& hand, VolumeViewWidget& widget, QObject* parent)
    : QObject(parent), m_model(model), m_hand(hand), m_widget(widget) {
    connect(&m_model, &DocumentModel::poseChanged, this, &DocumentView::showPose);
    connect(&m_model, &DocumentModel::beamChanged, this, &DocumentView::showPose);
    connect(&m_model, &DocumentModel::frontChanged, this, &DocumentView::showPose);
    connect(&m_model, &DocumentModel::boxChanged, this, &DocumentView::showPose);
    connect(&m_model, &DocumentModel::lookChanged, this, &DocumentView::showLook);
    connect(&m_model, &DocumentModel::panesChanged, this, [this] {
        leaveDesign();
        showCurve();
    });
    connect(&m_widget, &VolumeViewWidget::cameraChanged, this, &DocumentView::takePose);
    connect(&m_widget, &VolumeViewWidget::lightChanged, this, &DocumentView::takeLight);
    connect(&m_widget, &VolumeViewWidget::dragEnded, &m_model, &DocumentModel::commitPreview);
    connect(&m_widget, &VolumeViewWidget::dragCancelled, this, [this] {
        m_model.cancelPreview();
        // The widget is back where its drag began, which another step may have left since.
        showPose();
        showLook();
    });
    showLook();
    showPose();
}

void DocumentView::showVolume(const std::shared_ptr<const Volume>& volume,
                              const std::shared_ptr<const Volume>& measured) {
    if (m_held && awaitsDesign() && m_model.document().scene.look.mode == RenderMode::direct) {
        m_waiting = Volumes{volume, measured};
        emit designAwaited();
        return;
    }
    m_held = false;
    m_waiting.reset();
    showCurve();
    m_widget.setVolume(volume, measured);
    showLook();
    showPose();
}

void DocumentView::showPose() {
    if (m_held) return;
    const Document& document = m_model.document();
    m_widget.setPose(shownPose(document), document.beam.axis);
    m_widget.setNearCut(document.scene.front.depthMm);
    m_widget.setCutSurface(document.scene.front.surface);
    m_widget.setBox(viewpointOf(document).box);
}

void DocumentView::showCurve() {
    if (m_held || awaitsDesign()) return;
    m_widget.setClassification(
        classificationOf(m_model.document(), firstPane, {.curve = m_adaptive, .designed = m_designed}));
}

bool DocumentView::awaitsDesign() const {
    return designerConfigOf(m_model.document(), firstPane) != nullptr && !m_designed;
}

void DocumentView::hold() {
    m_held = true;
    m_designed.reset();
    m_waiting.reset();
}

void DocumentView::setDesigned(const Classification& designed) {
    m_designed = designed;
    if (const auto waiting = std::exchange(m_waiting, std::nullopt))
        showVolume(waiting->shown, waiting->measured);
    else
        showCurve();
}

void DocumentView::doWithoutDesign() {
    if (m_waiting) setDesigned(ManualCurve{});
}

/// A design that is left is none of the next one's.
void DocumentView::leaveDesign() {
    if (designerConfigOf(m_model.document(), firstPane) != nullptr) return;
    m_designed.reset();
    if (const auto waiting = std::exchange(m_waiting, std::nullopt)) showVolume(waiting->shown, waiting->measured);
}

void DocumentView::showLook() {
    if (!m_held) m_widget.setLook(m_model.document().scene.look);
}

void DocumentView::takePose() {
    if (m_held) return;  // what the hand moves is the picture of the study before
    const CameraStep step = cameraStep(m_model.document(), m_widget.pose());
    take(step.next, step.what);
    emit cameraMoved();
}

void DocumentView::takeLight() {
    if (m_held) return;
    Document next = m_model.document();
    next.scene.look.light = m_widget.look().light;
    take(next, tr("move light"));
}

void DocumentView::take(const Document& next, const QString& what) {
    if (m_widget.dragging())
        m_model.preview(next, what);
    else
        m_model.edit(next, what, m_hand.current());
}

}  // namespace echolucent
