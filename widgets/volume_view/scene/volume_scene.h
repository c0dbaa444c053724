// The 3D scene: the volume's picture, what is written over it, and room for further VTK actors. Knows no Qt.
#pragma once

#include <vtkNew.h>

#include <memory>

#include "widgets/volume_view/scene/orientation_marker.h"
#include "widgets/volume_view/scene/picture_request.h"
#include "widgets/volume_view/scene/scale_bar.h"

class vtkRenderer;
class vtkVolume;
class vtkVolumeProperty;

namespace echolucent {

class RayCastMapper;

/// One vtkRenderer in grid mm on black. To be used in one thread, the one that renders. Nothing here casts rays or
/// starts a rendering: show() and the setters only change the scene.
class VolumeScene {
public:
    VolumeScene();
    ~VolumeScene();
    VolumeScene(const VolumeScene&) = delete;
    VolumeScene& operator=(const VolumeScene&) = delete;

    /// For a render window; further actors may be added to it, in grid mm.
    [[nodiscard]] vtkRenderer* renderer() { return m_renderer; }
    /// The volume's prop, for pickers: its property carries the curve and the colours in use.
    [[nodiscard]] vtkVolume* volumeProp() { return m_volumeProp; }
    [[nodiscard]] const ScaleBar& scaleBar() const { return m_scaleBar; }

    /// Null: an empty scene, in which nothing is drawn. The picture of the volume before is dropped.
    void setVolume(std::shared_ptr<const Volume> volume);
    void setTransfer(const OpacityCurve& curve, ColourMap colourMap);
    /// Puts a finished picture in the scene and looks at the scene with the camera it was made for.
    void show(std::shared_ptr<const ScreenPicture> picture, const Camera& camera);
    [[nodiscard]] Camera camera();
    void setAnnotationsVisible(bool visible);

private:
    void layOutAnnotations();
    void updateVisibility();

    std::shared_ptr<const Volume> m_volume;
    vtkNew<vtkRenderer> m_renderer;
    vtkNew<RayCastMapper> m_mapper;
    vtkNew<vtkVolume> m_volumeProp;
    vtkNew<vtkVolumeProperty> m_property;
    OrientationMarker m_orientationMarker;
    ScaleBar m_scaleBar;
    bool m_annotationsVisible = true;
    bool m_hasPicture = false;
    unsigned long m_startObserver = 0;
};

}  // namespace echolucent
