#include "app/planes/room_controls.h"

#include "processing/document/box_editing.h"

namespace echolucent {

RoomControls::RoomControls(DocumentModel& model, HandGesture& hand, OpenStudy& openStudy,
                           const VolumeViewWidget& picture, RoomPanel& panel, QObject* parent)
    : QObject(parent), m_model(model), m_hand(hand), m_openStudy(openStudy), m_picture(picture), m_panel(panel) {
    connect(&m_panel, &RoomPanel::planesChanged, this, [this](const Planes& planes, const QString& what) {
        Document next = m_model.document();
        next.scene.planes = planes;
        edit(next, what);
    });
    connect(&m_panel, &RoomPanel::boxSwitched, this, &RoomControls::switchBox);
    connect(&m_panel, &RoomPanel::frontChosen, this, &RoomControls::chooseFront);
    connect(&m_panel, &RoomPanel::boxSizeChanged, this, &RoomControls::resizeBox);
    connect(&m_panel, &RoomPanel::wholeBoxRequested, this, &RoomControls::makeWhole);
    connect(&m_panel, &RoomPanel::slabRequested, this, &RoomControls::makeSlab);
    connect(&m_model, &DocumentModel::planesChanged, this, &RoomControls::show);
    connect(&m_model, &DocumentModel::boxChanged, this, &RoomControls::show);
    connect(&m_openStudy, &OpenStudy::studyOpened, this, [this] {
        const VolumeGeometry& geometry = m_openStudy.volume()->geometry();
        m_panel.setUnit(geometry.unit(), geometry.spacingKnown);
    });
    show();
}

void RoomControls::show() {
    m_panel.setPlanes(m_model.document().scene.planes);
    m_panel.setBox(m_model.document().scene.box);
}

void RoomControls::edit(const Document& next, const QString& what) {
    m_model.edit(next, what, m_hand.current());
    show();  // also where nothing changed: a button that was pressed stays as the document says
}

void RoomControls::switchBox(bool on) {
    if (!m_openStudy.volume()) return show();
    edit(withBoxSwitched(m_model.document(), on, m_openStudy.volume()->dataBox()),
         on ? tr("show the box") : tr("leave the box"));
}

void RoomControls::chooseFront(BoxSide front) {
    if (!m_openStudy.volume()) return show();
    edit(fitted(withSide(m_model.document(), front, m_openStudy.volume()->dataBox())), tr("front of the box"));
}

/// The same with the whole box in the picture, seen as it is.
Document RoomControls::fitted(Document document) const {
    document.scene.pose = m_picture.wholeVolume(viewpointOf(document), m_openStudy.volume()->dataBox());
    return document;
}

void RoomControls::resizeBox(int axis, double mm) {
    Box box = m_model.document().scene.box;
    box.sizeMm[axis] = mm;
    edit(withBox(m_model.document(), box), tr("size of the box"));
}

void RoomControls::makeWhole() {
    if (!m_openStudy.volume()) return;
    const Document& document = m_model.document();
    Box box = document.scene.box;
    box.direction = {};
    edit(withBox(document, wholeBox(box, document.beam.axis, m_openStudy.volume()->dataBox())),
         tr("box around all data"));
}

void RoomControls::makeSlab(PlaneName plane, double thicknessMm) {
    if (!m_openStudy.volume()) return;
    edit(fitted(withSlab(m_model.document(), plane, thicknessMm, m_openStudy.volume()->dataBox())),
         tr("slab around a plane"));
}

}  // namespace echolucent
