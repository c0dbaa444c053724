// The hand in the panes of a comparison makes steps of the document.
#pragma once

#include <QObject>
#include <functional>

#include "app/study/open_study.h"
#include "processing/picture/camera_pose.h"
#include "widgets/compare/compare_grid.h"
#include "widgets/document/document_model.h"

namespace echolucent {

/// Moves the pose, the light, and the line of a wipe. A drag is one step.
class CompareHand : public QObject {
    Q_OBJECT

public:
    /// What the parameters refer to must outlive this object.
    CompareHand(DocumentModel& model, OpenStudy& openStudy, CompareGrid& grid, QObject* parent = nullptr);

signals:
    /// The hand has moved the camera. If a motion had turned the view, the document's motionAngle is 0 again.
    void cameraMoved();

private:
    void moveCamera(const std::function<CameraPose(const CameraPose& camera, const ZoomLimits& limits)>& move);
    void moveLight(double right, double down);

    DocumentModel& m_model;
    OpenStudy& m_openStudy;
    CompareGrid& m_grid;
};

}  // namespace echolucent
