#include "tests/benchmarks/vtk_scene.h"

#include <vtkCamera.h>
#include <vtkImageData.h>
#include <vtkLight.h>
#include <vtkOpenGLGPUVolumeRayCastMapper.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>
#include <vtkVolume.h>
#include <vtkVolumeProperty.h>

#include <algorithm>
#include <cmath>

#include "processing/picture/view_limits.h"
#include "tests/benchmarks/staged_mapper.h"
#include "widgets/volume_view/scene/graphics_card/vtk_volume_image.h"
#include "widgets/volume_view/scene/vtk_camera.h"

namespace echolucent::bench {

namespace {

/// Room before and behind the volume, units: where it reaches to a thousandth of the clipping range, VTK casts rays
/// through the whole window instead of the volume's outline.
constexpr double roomUnits = 10.0;

/// Far end of the volume's box along `forward`, mm from the grid origin.
double hindmostDepth(const VolumeGeometry& geometry, const Vec3& forward) {
    const Vec3 low = geometry.boxMinMm(), high = geometry.boxMaxMm();
    double depth = 0.0;
    for (int axis = 0; axis < 3; ++axis) depth += std::max(forward[axis] * low[axis], forward[axis] * high[axis]);
    return depth;
}

void placeClippingPlanes(vtkCamera& vtk, const RayCastSettings& settings, const VolumeGeometry& geometry,
                         double shiftSteps) {
    const Camera& camera = settings.camera;
    const double stepMm = settings.step * geometry.unit();
    const double wholeSteps = std::ceil(roomUnits * geometry.unit() / stepMm);
    const double eyeDepth = camera.frame.forward.dot(camera.focalPoint) - camera.distanceMm;
    const double nearest = nearestDepthMm(settings, geometry);
    const double near = nearest - eyeDepth + (0.5 + shiftSteps - wholeSteps) * stepMm;
    const double far = hindmostDepth(geometry, camera.frame.forward) - eyeDepth + roomUnits * geometry.unit();
    vtk.SetClippingRange(near, far);
}

}  // namespace

VtkScene::VtkScene(Renderer renderer, const Volume& volume, int size, int threads)
    : m_size(size), m_geometry(volume.geometry()), m_volume(volume) {
    if (renderer == Renderer::fixedPoint) {
        m_fixedPoint = vtkSmartPointer<StagedFixedPointMapper>::New();
        m_fixedPoint->SetAutoAdjustSampleDistances(false);
        m_fixedPoint->SetLockSampleDistanceToInputSpacing(false);
        m_fixedPoint->SetImageSampleDistance(1.0f);
        m_fixedPoint->SetIntermixIntersectingGeometry(false);
        m_fixedPoint->SetNumberOfThreads(threads);
        m_mapper = m_fixedPoint;
    } else {
        auto gpu = vtkSmartPointer<vtkOpenGLGPUVolumeRayCastMapper>::New();
        gpu->SetAutoAdjustSampleDistances(false);
        gpu->SetLockSampleDistanceToInputSpacing(false);
        gpu->SetImageSampleDistance(1.0f);
        gpu->SetUseJittering(false);
        m_mapper = gpu;
    }
    m_mapper->SetInputData(imageOn(volume));
    m_volumeProp->SetMapper(m_mapper);
    m_volumeProp->SetProperty(m_property);
    m_renderer->SetBackground(0, 0, 0);
    m_renderer->AddVolume(m_volumeProp);
    m_window->SetOffScreenRendering(1);
    m_window->SetMultiSamples(0);
    m_window->SetSize(size, size);
    m_window->AddRenderer(m_renderer);
}

VtkScene::~VtkScene() = default;

void VtkScene::setLook(const OpacityCurve& curve, const RayCastSettings& settings, bool lit) {
    setTransfer(*m_property, m_volume, curve, settings.colourMap);
    m_property->SetShade(lit);
    if (!lit) return;
    const Shading shading;
    m_property->SetAmbient(shading.ambient);
    m_property->SetDiffuse(shading.diffuse);
    m_property->SetSpecular(shading.specular);
    m_property->SetSpecularPower(shading.specularPower);
    m_renderer->RemoveAllLights();
    vtkNew<vtkLight> light;
    light->SetLightTypeToCameraLight();  // its axes: right, up, backwards
    light->SetPosition(shading.towardsLight[0], -shading.towardsLight[1], -shading.towardsLight[2]);
    light->SetFocalPoint(0, 0, 0);
    m_renderer->AddLight(light);
}

VtkFrameCost VtkScene::draw(const RayCastSettings& settings, double shiftSteps) {
    vtkCamera& camera = *m_renderer->GetActiveCamera();
    setCamera(camera, settings.camera);
    placeClippingPlanes(camera, settings, m_geometry, shiftSteps);
    const auto stepMm = static_cast<float>(settings.step * m_geometry.unit());
    if (m_fixedPoint) {
        m_fixedPoint->SetSampleDistance(stepMm);
    } else {
        static_cast<vtkGPUVolumeRayCastMapper&>(*m_mapper).SetSampleDistance(stepMm);
    }
    VtkFrameCost cost;
    cost.frame = costOf([&] {
        m_window->Render();
        m_window->WaitForCompletion();
    });
    if (m_fixedPoint) {
        cost.setUp = m_fixedPoint->setUp();
        cost.rays = m_fixedPoint->rays();
    }
    return cost;
}

std::vector<float> VtkScene::rgb() const { return m_fixedPoint ? m_fixedPoint->rgb(m_size) : windowPixels(); }

std::vector<float> VtkScene::windowPixels() const {
    vtkNew<vtkUnsignedCharArray> bytes;
    m_window->GetPixelData(0, 0, m_size - 1, m_size - 1, 0, bytes);
    std::vector<float> rgb;
    for (int row = m_size - 1; row >= 0; --row)
        for (int byte = 0; byte < 3 * m_size; ++byte)
            rgb.push_back(static_cast<float>(bytes->GetValue(static_cast<vtkIdType>(row) * 3 * m_size + byte)) /
                          255.0f);
    return rgb;
}

std::string VtkScene::openGlRenderer() const {
    const std::string report = m_window->ReportCapabilities();
    const std::string key = "OpenGL renderer string:";
    const auto found = report.find(key);
    if (found == std::string::npos) return "unknown";
    const auto begin = report.find_first_not_of(' ', found + key.size());
    return report.substr(begin, report.find('\n', begin) - begin);
}

}  // namespace echolucent::bench
