#include "app/picture/document_view.h"

#include <utility>

#include "widgets/volume_view/volume_view_widget.h"

namespace echolucent {

DocumentView::DocumentView(DocumentModel& model, OpenStudy& openStudy, ShownPanes& panes, VolumeViewWidget& widget,
                           QObject* parent)
    : QObject(parent), m_model(model), m_openStudy(openStudy), m_panes(panes), m_widget(widget) {
    connect(&m_panes, &ShownPanes::changed, this, &DocumentView::follow);
    connect(&m_widget, &VolumeViewWidget::cameraChanged, this, &DocumentView::takePose);
    connect(&m_widget, &VolumeViewWidget::lightChanged, this, &DocumentView::takeLight);
    connect(&m_widget, &VolumeViewWidget::dragEnded, &m_model, &DocumentModel::commitPreview);
    connect(&m_widget, &VolumeViewWidget::dragCancelled, this, [this] {
        m_model.cancelPreview();
        // The widget has gone back to the start of its drag. Another step may have changed the document since.
        follow();
    });
    follow();
}

void DocumentView::follow() {
    const ShownPane& pane = m_panes.at(firstPane);
    const bool nothingIsOpen = m_openStudy.study() == nullptr;
    m_isCurrent = pane.ready || nothingIsOpen;
    if (!pane.ready) {
        // While a motion plays, a frame shows its pose and its OTF together.
        if (!held() && !m_panes.playing()) showPose();
        return;
    }
    const bool another = std::exchange(m_study, m_openStudy.study()) != m_openStudy.study();
    m_widget.setClassification(pane.classification);
    m_widget.setVolume(pane.voxels, pane.measured);
    showPose();
    if (another) emit studyGiven();
}

void DocumentView::showPose() {
    const Document& document = m_model.document();
    m_widget.setLook(shownLook(document.scene));
    m_widget.setPose(shownPose(document), document.beam.axis);
    m_widget.setLimits(viewpointOf(document));
}

void DocumentView::takePose() {
    if (held()) return;  // the hand moves the picture of the study before
    m_model.moveCamera(m_widget.pose(), m_widget.dragging());
    emit cameraMoved();
}

void DocumentView::takeLight() {
    if (held()) return;
    Document next = m_model.document();
    next.scene.look.light = m_widget.look().light;
    m_model.take(next, tr("move light"), m_widget.dragging());
}

}  // namespace echolucent
