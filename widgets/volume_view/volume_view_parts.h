// What the 3D view is made of; for its own source files only.
#pragma once

#include <QVTKOpenGLWindow.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>

#include <QPointF>
#include <memory>
#include <optional>

#include "widgets/volume_view/frame_meter.h"
#include "widgets/volume_view/progressive_caster.h"
#include "processing/picture/camera_pose.h"
#include "widgets/volume_view/scene/volume_scene.h"
#include "widgets/volume_view/view_pointer.h"
#include "widgets/volume_view/volume_view_widget.h"

namespace echolucent {

struct VolumeViewWidget::Parts {
    std::shared_ptr<const Volume> volume;
    OpacityCurve curve = PowerCurve{2, 1.0};
    Look look;
    CameraPose pose;
    CameraPose poseBeforeDrag;
    LightDirection lightBeforeDrag;
    Viewpoint fittedView;                      ///< the view and ...
    double fittedAspect = 1.0;                 ///< ... the shape of the picture that the zoom is measured against
    std::shared_ptr<const CastPicture> shown;  ///< without pictures where the graphics card draws
    std::optional<QPointF> cursor;             ///< while it rests over the picture, logical pixels
    bool scheduled = false;

    VolumeScene scene;
    vtkNew<vtkGenericOpenGLRenderWindow> renderWindow;
    QVTKOpenGLWindow* window = nullptr;  ///< owned by the container
    QWidget* container = nullptr;
    ViewPointer* pointer = nullptr;
    FrameMeter* meter = nullptr;
    // Last, so that its thread has ended before anything above is destroyed.
    ProgressiveCaster caster;
};

}  // namespace echolucent
