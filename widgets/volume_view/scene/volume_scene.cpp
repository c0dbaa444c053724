#include "widgets/volume_view/scene/volume_scene.h"

#include <vtkBoundingBox.h>
#include <vtkCamera.h>
#include <vtkCommand.h>
#include <vtkImageData.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkVolume.h>
#include <vtkVolumeProperty.h>

#include <array>

#include "widgets/volume_view/scene/graphics_card/card_answers.h"
#include "widgets/volume_view/scene/graphics_card/vtk_volume_image.h"
#include "widgets/volume_view/scene/ray_cast_mapper.h"
#include "widgets/volume_view/scene/vtk_camera.h"

namespace echolucent {

namespace {
constexpr double plainScreenDpi = 72.0;  // VTK's own default
}

VolumeScene::VolumeScene() {
    m_renderer->SetBackground(0, 0, 0);
    m_volumeProp->SetMapper(m_mapper);
    m_volumeProp->SetProperty(m_property);
    m_renderer->AddVolume(m_volumeProp);
    m_overlay.addTo(m_renderer);
    m_orientationMarker.addTo(m_renderer);
    m_scaleBar.addTo(m_renderer);
    m_caption.addTo(m_renderer);
    m_shade.addTo(m_renderer);  // last: it lies over all others
    // The window's size is certain only when it is drawn.
    m_startObserver = m_renderer->AddObserver(vtkCommand::StartEvent, this, &VolumeScene::prepareDrawing);
    updateVisibility();
}

VolumeScene::~VolumeScene() { m_renderer->RemoveObserver(m_startObserver); }

vtkRenderer* VolumeScene::renderer() { return m_renderer; }

void VolumeScene::setVolume(std::shared_ptr<const Volume> volume) {
    m_mapper->setPicture(nullptr);
    m_mapper->card().forgetFailure();
    m_mapper->card().forgetPictures();
    m_hasPicture = false;
    m_transfer.reset();
    if (volume) {
        m_mapper->SetInputData(imageOn(*volume));
    } else {
        m_mapper->SetInputData(static_cast<vtkImageData*>(nullptr));
    }
    m_volume = std::move(volume);  // only after the image on the former volume's memory is freed
    updateVisibility();
}

void VolumeScene::setTransfer(const Classification& classification, ColourMap colourMap) {
    const Transfer transfer{classification, colourMap};
    if (!m_volume || m_transfer == transfer) return;
    echolucent::setTransfer(*m_property, *m_volume, upperCurveOf(classification), colourMap);
    m_transfer = transfer;
}

void VolumeScene::show(std::shared_ptr<const ScreenPicture> picture, const Camera& camera) {
    m_mapper->setPicture(std::move(picture));
    lookThrough(camera);
}

void VolumeScene::show(std::shared_ptr<const CardPicture> picture, std::shared_ptr<const KnownCardPicture> known) {
    const Camera camera = picture->settings.camera;
    m_mapper->setCardPicture(std::move(picture), std::move(known));
    lookThrough(camera);
}

void VolumeScene::lookThrough(const Camera& camera) {
    m_hasPicture = true;
    updateVisibility();
    vtkCamera& vtk = *m_renderer->GetActiveCamera();
    echolucent::setCamera(vtk, camera);
    vtkBoundingBox box(m_renderer->ComputeVisiblePropBounds());
    if (m_volume) {
        // VTK's bounds end at voxel centres.
        for (Vec3 corner : {m_volume->geometry().boxMinMm(), m_volume->geometry().boxMaxMm()}) box.AddPoint(corner.val);
    }
    if (!box.IsValid()) return;
    std::array<double, 6> bounds{};
    box.GetBounds(bounds.data());
    setClippingRange(vtk, bounds);
}

Camera VolumeScene::camera() { return cameraOf(*m_renderer->GetActiveCamera()); }

void VolumeScene::setAnnotationsVisible(bool visible) {
    m_annotationsVisible = visible;
    updateVisibility();
}

void VolumeScene::setCaption(const std::string& text) {
    m_caption.setText(text);
    updateVisibility();
}

const std::string& VolumeScene::openGlRenderer() const { return m_mapper->card().card().renderer; }

void VolumeScene::setRenderer(RendererChoice choice) {
    m_choice = choice;
    m_mapper->card().forgetFailure();
}

void VolumeScene::forgetCard() { m_mapper->card().forget(); }

void VolumeScene::setCardAnswers(const CardAnswers& answers) { m_mapper->setCardAnswers(answers); }

void VolumeScene::setCardPatience(double milliseconds) { m_mapper->setCardPatience(milliseconds); }

bool VolumeScene::cardGoesOn() const { return m_mapper->card().goesOn(); }

double VolumeScene::cardMilliseconds() const {
    return m_mapper->card().uploadMilliseconds() + m_mapper->card().drawMilliseconds();
}

bool VolumeScene::graphicsCardAtHand() const {
    return !openGlRenderer().empty() && !isSoftwareOpenGl(openGlRenderer());
}

RendererChoice VolumeScene::rendererInUse() const {
    const bool software = m_choice == RendererChoice::software || !whySoftware().empty();
    return software ? RendererChoice::software : RendererChoice::graphicsCard;
}

std::string VolumeScene::whySoftware() const {
    if (m_choice == RendererChoice::software) return {};
    if (openGlRenderer().empty()) return "The graphics card is not known before the first picture.";
    if (m_choice == RendererChoice::automatic && !graphicsCardAtHand()) {
        return "OpenGL is software here (" + openGlRenderer() + "): the software ray caster is faster.";
    }
    if (m_depthWanted) return "Pickers want the depth of each pixel, which the software renderer finds.";
    const CardRenderer& card = m_mapper->card();
    if (!card.failure().empty() || !m_volume) return card.failure();
    const int* size = m_renderer->GetSize();
    return whyTooLarge(m_volume->geometry(), bytesOnCard(*m_volume, size[0], size[1]), card.card());
}

void VolumeScene::updateVisibility() {
    const bool visible = m_annotationsVisible && m_volume && m_hasPicture;
    m_volumeProp->SetVisibility(m_volume != nullptr);
    m_orientationMarker.setVisible(visible);
    m_scaleBar.setVisible(visible);
    m_caption.setVisible(visible);
    m_overlay.setVisible(m_volume && m_hasPicture);
}

void VolumeScene::prepareDrawing() {
    auto* window = vtkOpenGLRenderWindow::SafeDownCast(m_renderer->GetRenderWindow());
    if (window) m_mapper->card().meet(*window);
    const int* size = m_renderer->GetSize();
    m_shade.layOut(size[0], size[1]);
    layOutAnnotations();
}

void VolumeScene::layOutAnnotations() {
    if (!m_volume || !m_hasPicture) return;
    const int* size = m_renderer->GetSize();
    const double scale = m_renderer->GetRenderWindow()->GetDPI() / plainScreenDpi;
    const Camera shown = camera();
    m_orientationMarker.layOut(scale, shown.frame);
    m_caption.layOut(size[0], size[1], scale);
    m_overlay.layOut(size[0], size[1], scale, shown);
    m_scaleBar.layOut(size[0], size[1], scale, shown.heightMm, m_volume->geometry().spacingKnown);
}

}  // namespace echolucent
