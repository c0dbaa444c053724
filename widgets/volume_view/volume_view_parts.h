// The parts of the 3D view, for its own source files only.
#pragma once

#include <QVTKOpenGLWindow.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>

#include <QPointF>
#include <memory>
#include <optional>

#include "processing/scene/pose.h"
#include "widgets/casting/progressive_caster.h"
#include "widgets/threads/works.h"
#include "widgets/volume_view/frame_meter.h"
#include "widgets/volume_view/grip_pointer.h"
#include "widgets/volume_view/lasso_pointer.h"
#include "widgets/volume_view/scene/volume_scene.h"
#include "widgets/volume_view/view_pointer.h"
#include "widgets/volume_view/volume_view_widget.h"

namespace echolucent {

struct VolumeViewWidget::Parts {
    explicit Parts(Works& works) : asks(works, {}), cardDraws(works, {}), caster(works) {}

    std::shared_ptr<const Volume> volume;
    std::shared_ptr<const Volume> measured;  ///< pointed values are read from it; null only if the volume is null
    Classification classification = PowerCurve{2, 1.0};
    Look look;
    Pose pose;
    BeamAxis beam = BeamAxis::plusZ;
    Viewpoint limits;  ///< front and box; its direction plays no part
    Pose poseBeforeDrag;
    LightDirection lightBeforeDrag;
    std::shared_ptr<const CastPicture> shown;
    std::optional<QPointF> cursor;         ///< over the picture, logical pixels; no value elsewhere
    bool scheduled = false;                ///< whether a request is on its way
    Works::UnderWay asks;                  ///< until the request is made
    Works::UnderWay cardDraws;             ///< while the card is not done with the newest picture
    const CastPicture* drawsOn = nullptr;  ///< the picture with which a timer lets the card go on; else null
    bool dimmed = false;                   ///< whether the picture on the screen is dimmed
    bool toRedraw = false;                 ///< whether the overlay or caption has changed since it was drawn

    VolumeScene scene;
    vtkNew<vtkGenericOpenGLRenderWindow> renderWindow;
    QVTKOpenGLWindow* window = nullptr;  ///< owned by the container
    QWidget* container = nullptr;
    ViewPointer* pointer = nullptr;
    GripPointer* grips = nullptr;
    LassoPointer* lasso = nullptr;
    FrameMeter* meter = nullptr;
    // Last member: its thread ends before anything above is destroyed.
    ProgressiveCaster caster;
};

}  // namespace echolucent
