// The panes of planes A, B and C, which show one view of the document.
#pragma once

#include <QObject>
#include <array>

#include "app/study/open_study.h"
#include "widgets/document/document_model.h"
#include "widgets/planes/plane_pane.h"
#include "widgets/planes/plane_resampler.h"

namespace echolucent {

/// Brings the document's planes and the voxels of the phase shown to the panes. Has the planes resampled. Makes steps
/// of what the hand does in the panes.
class DocumentPlanes : public QObject {
    Q_OBJECT

public:
    using Panes = std::array<PlanePane*, 3>;  ///< A, B, C

    /// What the parameters refer to must outlive this object.
    DocumentPlanes(DocumentModel& model, OpenStudy& openStudy, Works& works, const Panes& panes,
                   QObject* parent = nullptr);

    /// Resets all planes, their pictures and greys to those on opening, in one step. Keeps the choice of quiet voxels,
    /// whether the 3D view shows lines, and whether it turns along.
    void resetAll();
    /// Ends a drag in a pane; false if there is none.
    bool cancelDrag();

signals:
    /// The planes were turned, and the camera along with them.
    void cameraMoved();
    /// The normalised intensity under the cursor, as read, whatever voxels the plane shows; no value if there is none.
    void pointed(std::optional<double> intensity);

private:
    void show();
    void resample();
    [[nodiscard]] BoxScene boxScene(const Volume& volume) const;
    [[nodiscard]] PlaneScene sceneFor(const Volume& volume, const BoxScene& box, PlaneName plane) const;
    void take(const Planes& next, const QString& what, DocumentModel::Gesture gesture);
    void wheelFront(double mm, const QString& what);
    [[nodiscard]] Front movedFront(const Document& document, double mm) const;
    void takeBox(const BoxGrip& grip, const BoxDrag& dragged, const QString& what);
    [[nodiscard]] Document with(const Planes& next) const;

    DocumentModel& m_model;
    OpenStudy& m_openStudy;
    Panes m_panes;
    PlaneResampler m_resampler;
    std::optional<Document> m_beforeBoxDrag;
    DocumentModel::Gesture m_newestGesture = DocumentModel::noGesture;  ///< of the newest step in a pane
};

}  // namespace echolucent
