// Makes steps of the room panel's requests for the box, with the data box of the open volume.
#pragma once

#include <QObject>

#include "app/study/open_study.h"
#include "widgets/document/document_model.h"
#include "widgets/panels/room_panel.h"
#include "widgets/volume_view/volume_view_widget.h"

namespace echolucent {

class RoomControls : public QObject {
    Q_OBJECT

public:
    /// What the parameters refer to must outlive this object. `picture` is the 3D view.
    RoomControls(DocumentModel& model, OpenStudy& openStudy, const VolumeViewWidget& picture, RoomPanel& panel,
                 QObject* parent = nullptr);

    void switchBox(bool on);

private:
    [[nodiscard]] Document fitted(Document document) const;
    void resizeBox(int axis, double mm);
    void makeWhole();
    void makeSlab(PlaneName plane, double thicknessMm);

    DocumentModel& m_model;
    OpenStudy& m_openStudy;
    const VolumeViewWidget& m_picture;
};

}  // namespace echolucent
