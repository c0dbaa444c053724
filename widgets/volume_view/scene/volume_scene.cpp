#include "widgets/volume_view/scene/volume_scene.h"

#include <vtkCommand.h>
#include <vtkImageData.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkVolume.h>
#include <vtkVolumeProperty.h>

#include "widgets/volume_view/scene/ray_cast_mapper.h"
#include "widgets/volume_view/scene/vtk_camera.h"
#include "widgets/volume_view/scene/vtk_volume_image.h"

namespace echolucent {

namespace {
constexpr double plainScreenDpi = 72.0;  // VTK's own default
}

VolumeScene::VolumeScene() {
    m_renderer->SetBackground(0, 0, 0);
    m_volumeProp->SetMapper(m_mapper);
    m_volumeProp->SetProperty(m_property);
    m_renderer->AddVolume(m_volumeProp);
    m_orientationMarker.addTo(m_renderer);
    m_scaleBar.addTo(m_renderer);
    // The window's size is known for certain only when it is drawn.
    m_startObserver = m_renderer->AddObserver(vtkCommand::StartEvent, this, &VolumeScene::layOutAnnotations);
    updateVisibility();
}

VolumeScene::~VolumeScene() { m_renderer->RemoveObserver(m_startObserver); }

void VolumeScene::setVolume(std::shared_ptr<const Volume> volume) {
    m_mapper->setPicture(nullptr);
    m_hasPicture = false;
    if (volume) {
        m_mapper->SetInputData(imageOn(*volume));
    } else {
        m_mapper->SetInputData(static_cast<vtkImageData*>(nullptr));
    }
    m_volume = std::move(volume);  // after the image on the volume before is let go
    updateVisibility();
}

void VolumeScene::setTransfer(const OpacityCurve& curve, ColourMap colourMap) {
    if (m_volume) echolucent::setTransfer(*m_property, *m_volume, curve, colourMap);
}

void VolumeScene::show(std::shared_ptr<const ScreenPicture> picture, const Camera& camera) {
    m_mapper->setPicture(std::move(picture));
    m_hasPicture = true;
    echolucent::setCamera(*m_renderer->GetActiveCamera(), camera);
    m_renderer->ResetCameraClippingRange();
    updateVisibility();
}

Camera VolumeScene::camera() { return cameraOf(*m_renderer->GetActiveCamera()); }

void VolumeScene::setAnnotationsVisible(bool visible) {
    m_annotationsVisible = visible;
    updateVisibility();
}

void VolumeScene::updateVisibility() {
    const bool visible = m_annotationsVisible && m_volume && m_hasPicture;
    m_volumeProp->SetVisibility(m_volume != nullptr);
    m_orientationMarker.setVisible(visible);
    m_scaleBar.setVisible(visible);
}

void VolumeScene::layOutAnnotations() {
    if (!m_volume || !m_hasPicture) return;
    const int* size = m_renderer->GetSize();
    const double scale = m_renderer->GetRenderWindow()->GetDPI() / plainScreenDpi;
    const Camera shown = camera();
    m_orientationMarker.layOut(scale, shown.frame);
    m_scaleBar.layOut(size[0], size[1], scale, shown.heightMm, m_volume->geometry().spacingKnown);
}

}  // namespace echolucent
