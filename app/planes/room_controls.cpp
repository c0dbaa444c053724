#include "app/planes/room_controls.h"

#include "processing/document/box_editing.h"

namespace echolucent {

RoomControls::RoomControls(DocumentModel& model, OpenStudy& openStudy, const VolumeViewWidget& picture,
                           RoomPanel& panel, QObject* parent)
    : QObject(parent), m_model(model), m_openStudy(openStudy), m_picture(picture) {
    connect(&panel, &RoomPanel::boxSwitched, this, &RoomControls::switchBox);
    connect(&panel, &RoomPanel::boxSizeChanged, this, &RoomControls::resizeBox);
    connect(&panel, &RoomPanel::wholeBoxRequested, this, &RoomControls::makeWhole);
    connect(&panel, &RoomPanel::slabRequested, this, &RoomControls::makeSlab);
    connect(&m_openStudy, &OpenStudy::studyOpened, this, [this, &panel] {
        const VolumeGeometry& geometry = m_openStudy.volume()->geometry();
        panel.setUnit(geometry.unit(), geometry.spacingKnown);
    });
}

void RoomControls::switchBox(bool on) {
    if (!m_openStudy.volume()) return;
    m_model.edit(withBoxSwitched(m_model.document(), on, m_openStudy.volume()->dataBox()),
                 on ? tr("show the box") : tr("leave the box"));
}

/// The document with a pose that shows the whole box.
Document RoomControls::fitted(Document document) const {
    document.scene.pose = m_picture.wholeVolume(viewpointOf(document), m_openStudy.volume()->dataBox());
    return document;
}

void RoomControls::resizeBox(int axis, double mm) {
    m_model.change(tr("size of the box"), [&](Document& next) { next.scene.box.sizeMm[axis] = mm; });
}

void RoomControls::makeWhole() {
    if (!m_openStudy.volume()) return;
    Document next = m_model.document();
    next.scene.box.direction = {};
    next.scene.box = wholeBox(next.scene.box, next.beam.axis, m_openStudy.volume()->dataBox());
    m_model.edit(next, tr("box around all data"));
}

void RoomControls::makeSlab(PlaneName plane, double thicknessMm) {
    if (!m_openStudy.volume()) return;
    m_model.edit(fitted(withSlab(m_model.document(), plane, thicknessMm, m_openStudy.volume()->dataBox())),
                 tr("slab around a plane"));
}

}  // namespace echolucent
