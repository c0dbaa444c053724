#include "app/document/document_view.h"

#include <utility>

#include "app/document/camera_step.h"
#include "processing/document/view_caster.h"
#include "widgets/volume_view/volume_view_widget.h"

namespace echolucent {

DocumentView::DocumentView(DocumentModel& model, int view, HandGesture& hand, VolumeViewWidget& widget, QObject* parent)
    : QObject(parent), m_model(model), m_view(view), m_hand(hand), m_widget(widget) {
    connect(&m_model, &DocumentModel::posesChanged, this, &DocumentView::showPose);
    connect(&m_model, &DocumentModel::beamChanged, this, &DocumentView::showPose);
    connect(&m_model, &DocumentModel::cutsChanged, this, &DocumentView::showPose);
    connect(&m_model, &DocumentModel::boxesChanged, this, &DocumentView::showPose);
    connect(&m_model, &DocumentModel::looksChanged, this, &DocumentView::showLook);
    connect(&m_model, &DocumentModel::viewsChanged, this, [this] {
        leaveDesign();
        showCurve();
        showPose();
        showLook();
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
    if (m_held && awaitsDesign() && lookOf(m_model.document(), m_view).mode == RenderMode::direct) {
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
    m_widget.setPose(shownPose(document, m_view), document.beam.axis);
    m_widget.setNearCut(cutOf(document, m_view).nearCutMm);
    m_widget.setCutSurface(cutOf(document, m_view).surface);
    m_widget.setBox(viewpointOf(document, m_view).box);
}

void DocumentView::showCurve() {
    if (m_held || awaitsDesign()) return;
    m_widget.setClassification(
        classificationOf(m_model.document(), m_view, {.curve = m_adaptive, .designed = m_designed}));
}

bool DocumentView::awaitsDesign() const { return designOf(m_model.document(), m_view) != nullptr && !m_designed; }

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
    if (designOf(m_model.document(), m_view) != nullptr) return;
    m_designed.reset();
    if (const auto waiting = std::exchange(m_waiting, std::nullopt)) showVolume(waiting->shown, waiting->measured);
}

void DocumentView::showLook() {
    if (!m_held) m_widget.setLook(lookOf(m_model.document(), m_view));
}

void DocumentView::takePose() {
    if (m_held) return;  // what the hand moves is the picture of the study before
    const CameraStep step = cameraStep(m_model.document(), m_view, m_widget.pose());
    take(step.next, step.what);
    emit cameraMoved();
}

void DocumentView::takeLight() {
    if (m_held) return;
    Document next = m_model.document();
    lookOf(next, m_view).light = m_widget.look().light;
    take(next, tr("move light"));
}

void DocumentView::take(const Document& next, const QString& what) {
    if (m_widget.dragging())
        m_model.preview(next, what);
    else
        m_model.edit(next, what, m_hand.current());
}

}  // namespace echolucent
