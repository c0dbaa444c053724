// Box, front, planes and measurements in the 3D view: draws them over the picture, and lets the hand drag box and
// front.
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

/// The hand drags faces, edges, corners and the centre of the box in the picture, and the front by its handle. A drag
/// is one step.
class BoxIn3d : public QObject {
    Q_OBJECT

public:
    /// What the parameters refer to must outlive this object.
    BoxIn3d(DocumentModel& model, OpenStudy& openStudy, VolumeViewWidget& picture, QObject* parent = nullptr);

    /// Sets the drawing of the scalpel, which lies over all else.
    void setDrawing(const std::optional<PictureLine>& drawing);
    /// Whether the front and its handle are drawn; at first they are not.
    void showFront(bool shown);
    /// Sets the marks of an unfinished measurement. They lie over finished measurements.
    void setMarking(const Overlay& marking);
    /// Sets the marks of tube cores, which lie below box, front and measurements.
    void setTubeCores(const Overlay& tubeCores);

private:
    /// The faces that the hand holds together: none for the centre, one for a face, two for an edge, three for a
    /// corner.
    using Grip = std::vector<BoxFace>;
    void show();
    [[nodiscard]] std::vector<Vec3> addBox(Overlay& overlay);
    [[nodiscard]] std::optional<Vec3> addFront(Overlay& overlay) const;
    void addPlanes(Overlay& overlay) const;
    void addMeasurements(Overlay& overlay) const;
    void drag(const Vec3& mm);
    void dragFront(const Vec3& mm);

    DocumentModel& m_model;
    OpenStudy& m_openStudy;
    VolumeViewWidget& m_picture;
    std::vector<Grip> m_grips;
    bool m_frontIsShown = false;
    bool m_hasHandle = false;   ///< whether the first of the pointer's grips is the front's handle
    bool m_holdsFront = false;  ///< whether the hand holds that handle
    std::optional<PictureLine> m_drawing;
    Overlay m_marking, m_tubeCores;
    Grip m_held;                       ///< the grip being dragged
    std::optional<Document> m_before;  ///< the document when the drag began
};

}  // namespace echolucent
