// Box, planes and measurements in the 3D view: drawn over the picture, and the box dragged there.
#pragma once

#include <QObject>
#include <optional>
#include <vector>

#include "app/study/open_study.h"
#include "processing/viewpoint/box_section.h"
#include "widgets/document/document_model.h"
#include "widgets/volume_view/scene/annotation/overlay.h"

namespace echolucent {

class VolumeViewWidget;

/// Faces, edges, corners and the centre of the box can be dragged in the picture; a drag is one step.
class BoxIn3d : public QObject {
    Q_OBJECT

public:
    /// All of them must outlive this.
    BoxIn3d(DocumentModel& model, OpenStudy& openStudy, VolumeViewWidget& picture, QObject* parent = nullptr);

    /// What the scalpel draws lies over all else.
    void setDrawing(const std::optional<PictureLine>& drawing);
    /// What is being measured lies over what was measured.
    void setMarking(const Overlay& marking);

private:
    /// What is held together: no face is the centre, one a face, two an edge, three a corner.
    using Grip = std::vector<BoxFace>;
    void show();
    void addBox(Overlay& overlay);
    void addPlanes(Overlay& overlay) const;
    void addMeasurements(Overlay& overlay) const;
    void drag(const Vec3& mm);

    DocumentModel& m_model;
    OpenStudy& m_openStudy;
    VolumeViewWidget& m_picture;
    std::vector<Grip> m_grips;
    std::optional<PictureLine> m_drawing;
    Overlay m_marking;
    Grip m_held;                       ///< what is dragged
    std::optional<Document> m_before;  ///< when the drag began
};

}  // namespace echolucent
