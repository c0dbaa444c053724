#include "widgets/volume_view/scene/graphics_card_volume.h"

#include <vtkCommand.h>
#include <vtkImageData.h>
#include <vtkLight.h>
#include <vtkLightCollection.h>
#include <vtkOpenGLGPUVolumeRayCastMapper.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPlane.h>
#include <vtkPlaneCollection.h>
#include <vtkRenderer.h>
#include <vtkShaderProperty.h>
#include <vtkTextureObject.h>
#include <vtkVolume.h>
#include <vtkVolumeProperty.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "widgets/volume_view/scene/vtk_volume_image.h"

namespace echolucent {

namespace {

constexpr std::size_t mostPlanes = 8;  // that VTK's shader holds

int blendModeOf(RenderMode mode) {
    switch (mode) {
        case RenderMode::maximum: return vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND;
        case RenderMode::minimum: return vtkVolumeMapper::MINIMUM_INTENSITY_BLEND;
        case RenderMode::mean: return vtkVolumeMapper::AVERAGE_INTENSITY_BLEND;
        case RenderMode::direct: break;
    }
    return vtkVolumeMapper::COMPOSITE_BLEND;
}

bool needsNearPlane(const RayCastSettings& look) { return std::isfinite(look.nearPlaneDepthMm); }

}  // namespace

GraphicsCardVolume::GraphicsCardVolume() {
    m_prop->SetMapper(m_mapper);
    m_prop->SetProperty(m_property);
    m_mapper->SetAutoAdjustSampleDistances(false);
    m_mapper->SetLockSampleDistanceToInputSpacing(false);
    m_mapper->SetImageSampleDistance(1.0f);
    m_mapper->SetUseJittering(false);
    m_mapper->SetMaskTypeToBinary();
    m_mapper->SetCroppingRegionFlagsToSubVolume();
    m_opaque->AddPoint(0.0, 1.0);
    m_mapper->AddObserver(vtkCommand::ErrorEvent, this, &GraphicsCardVolume::noteError);
}

GraphicsCardVolume::~GraphicsCardVolume() { m_mapper->RemoveAllObservers(); }

void GraphicsCardVolume::setVolume(std::shared_ptr<const Volume> volume) {
    if (volume == m_volume) return;
    m_failure.clear();
    m_checked = false;
    if (volume) {
        const CellImages images = cellImagesOf(*volume);
        m_mapper->SetInputData(images.voxels);
        m_mapper->SetMaskInput(images.mask);
    } else {
        m_mapper->SetInputData(static_cast<vtkImageData*>(nullptr));
        m_mapper->SetMaskInput(nullptr);
    }
    m_volume = std::move(volume);  // after the image on the volume before is let go
}

std::string GraphicsCardVolume::whyNot(const RayCastSettings& look) {
    if (look.depthColouring) return "Depth colouring is drawn by the software ray caster.";
    if (look.clippingPlanes.size() + needsNearPlane(look) > mostPlanes) {
        return "There are more clipping planes than VTK's graphics card mapper takes.";
    }
    return {};
}

void GraphicsCardVolume::setLook(const RayCastSettings& look, vtkVolumeProperty& transfer) {
    if (!m_volume) return;
    const double unit = m_volume->geometry().unit();
    m_mapper->SetSampleDistance(static_cast<float>(look.step * unit));
    setMode(look.mode);
    setPlanes(look);
    setBox(look);

    m_property->SetColor(transfer.GetRGBTransferFunction());
    if (look.mode == RenderMode::direct) {
        m_property->SetScalarOpacity(transfer.GetScalarOpacity());
    } else {
        // VTK weights these modes by the curve, which plays no part in ours.
        m_property->SetScalarOpacity(m_opaque);
    }
    m_property->SetScalarOpacityUnitDistance(unit);
    if (look.interpolation == Interpolation::nearest) {
        m_property->SetInterpolationTypeToNearest();
    } else {
        m_property->SetInterpolationTypeToLinear();
    }
    const bool shaded = look.shading && look.mode == RenderMode::direct;
    m_property->SetShade(shaded);
    if (!shaded) return;
    m_property->SetAmbient(look.shading->ambient);
    m_property->SetDiffuse(look.shading->diffuse);
    m_property->SetSpecular(look.shading->specular);
    m_property->SetSpecularPower(look.shading->specularPower);
}

void GraphicsCardVolume::setPlanes(const RayCastSettings& look) {
    std::vector<ClippingPlane> planes = look.clippingPlanes;
    const Vec3& forward = look.camera.frame.forward;
    if (needsNearPlane(look)) planes.push_back({forward * look.nearPlaneDepthMm, forward});
    // VTK composes its shader anew for another collection, not for planes that move.
    if (static_cast<std::size_t>(m_planes->GetNumberOfItems()) != planes.size()) {
        m_planes = vtkSmartPointer<vtkPlaneCollection>::New();
        for (std::size_t i = 0; i < planes.size(); ++i) m_planes->AddItem(vtkNew<vtkPlane>());
        m_mapper->SetClippingPlanes(planes.empty() ? nullptr : m_planes.Get());
    }
    for (std::size_t i = 0; i < planes.size(); ++i) {
        vtkPlane* plane = m_planes->GetItem(static_cast<int>(i));
        plane->SetOrigin(planes[i].point.val);
        plane->SetNormal(planes[i].normal.val);
    }
}

void GraphicsCardVolume::setBox(const RayCastSettings& look) {
    m_mapper->SetCropping(look.box.has_value());
    if (!look.box) return;
    const RenderBox& box = *look.box;
    m_mapper->SetCroppingRegionPlanes(box.low[0], box.high[0], box.low[1], box.high[1], box.low[2], box.high[2]);
}

void GraphicsCardVolume::setMode(RenderMode mode) {
    if (m_mode == mode) return;
    m_mode = mode;
    m_mapper->SetBlendMode(blendModeOf(mode));
    constexpr const char* exit = "//VTK::Shading::Exit";
    vtkShaderProperty* shaders = m_prop->GetShaderProperty();
    shaders->ClearAllShaderReplacements();
    constexpr bool beforeVtk = true, everywhere = false;
    if (mode == RenderMode::mean) {
        // VTK shows the mean in grey, whatever the colour map.
        shaders->AddFragmentShaderReplacement(exit, beforeVtk,
                                              "if (l_numSamples.x == uint(0)) discard;\n"
                                              "g_srcColor = computeColor(vec4(l_avgValue.x / float(l_numSamples.x)), 1.0);\n"
                                              "g_fragColor = vec4(g_srcColor.rgb, 1.0);\n",
                                              everywhere);
    } else if (mode == RenderMode::maximum || mode == RenderMode::minimum) {
        // Without a sample VTK shows the colour of 0 or of white.
        shaders->AddFragmentShaderReplacement(exit, beforeVtk, std::string("if (l_firstValue) discard;\n") + exit,
                                              everywhere);
    }
}

void GraphicsCardVolume::setLight(vtkRenderer& renderer, const std::optional<Shading>& shading) {
    vtkLightCollection* lights = renderer.GetLights();
    auto* only = lights->GetNumberOfItems() == 1 ? vtkLight::SafeDownCast(lights->GetItemAsObject(0)) : nullptr;
    const bool none = lights->GetNumberOfItems() == 0;
    if (!none && only != m_light.Get() && !(only && only->LightTypeIsHeadlight())) return;
    if (!shading) {
        if (only == m_light.Get()) renderer.RemoveAllLights();  // VTK makes its own again
        return;
    }
    // In the camera's coordinates, x right, y up, z towards the eye.
    const Vec3& light = shading->towardsLight;
    m_light->SetLightTypeToCameraLight();
    m_light->SetPositional(false);
    m_light->SetFocalPoint(0, 0, 0);
    m_light->SetPosition(light[0], -light[1], -light[2]);
    if (only == m_light.Get()) return;
    renderer.RemoveAllLights();
    renderer.AddLight(m_light);
}

bool GraphicsCardVolume::fits(vtkOpenGLRenderWindow& window) {
    if (m_checked) return true;
    const auto& size = m_volume->geometry().size;
    vtkNew<vtkTextureObject> probe;
    probe->SetContext(&window);
    const int type = std::visit([](const auto& voxels) {
        return vtkTypeOf<typename std::decay_t<decltype(voxels)>::value_type>();
    }, m_volume->voxels());
    m_checked = probe->AllocateProxyTexture3D(static_cast<unsigned>(size[0]), static_cast<unsigned>(size[1]),
                                              static_cast<unsigned>(size[2]), 1, type);
    if (!m_checked) m_failure = "The graphics card cannot hold the volume.";
    return m_checked;
}

void GraphicsCardVolume::draw(vtkRenderer& renderer, vtkOpenGLRenderWindow& window) {
    if (!m_volume || !m_failure.empty() || !fits(window)) return;
    m_mapper->Render(&renderer, m_prop);
}

void GraphicsCardVolume::noteError(vtkObject*, unsigned long, void* text) {
    std::string said = text ? static_cast<const char*>(text) : "";
    // VTK's report ends with the message, after the name of the object.
    if (const std::size_t colon = said.rfind("): "); colon != std::string::npos) said.erase(0, colon + 3);
    said.erase(std::remove(said.begin(), said.end(), '\n'), said.end());
    m_failure = "The graphics card could not draw the volume: " + said;
}

double GraphicsCardVolume::milliseconds() const { return m_mapper->GetTimeToDraw() * 1000.0; }

void GraphicsCardVolume::releaseGraphicsResources(vtkWindow* window) {
    m_mapper->ReleaseGraphicsResources(window);
    m_checked = false;
}

}  // namespace echolucent
