#include "widgets/volume_view/scene/graphics_card/graphics_card_volume.h"

#include <vtkCommand.h>
#include <vtkImageData.h>
#include <vtkOpenGLGPUVolumeRayCastMapper.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPlane.h>
#include <vtkPlaneCollection.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkTextureObject.h>
#include <vtkVolume.h>
#include <vtkVolumeProperty.h>

#include <algorithm>
#include <cmath>

#include "widgets/volume_view/scene/graphics_card/vtk_volume_image.h"

namespace echolucent {

namespace {

constexpr std::size_t mostPlanes = 8;  // clipping planes that VTK's shader holds

int blendModeOf(RenderMode mode) {
    switch (mode) {
        case RenderMode::maximum: return vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND;
        case RenderMode::minimum: return vtkVolumeMapper::MINIMUM_INTENSITY_BLEND;
        case RenderMode::mean: return vtkVolumeMapper::AVERAGE_INTENSITY_BLEND;
        case RenderMode::direct: break;
    }
    return vtkVolumeMapper::COMPOSITE_BLEND;
}

}  // namespace

GraphicsCardVolume::GraphicsCardVolume() : m_planes(vtkSmartPointer<vtkPlaneCollection>::New()) {
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
    m_volume = std::move(volume);  // only after the image on the former volume's memory is freed
}

std::string GraphicsCardVolume::whyNot(const RayCastSettings& look) {
    if (look.clippingPlanes.size() + look.front.has_value() > mostPlanes) {
        return "There are more clipping planes than VTK's graphics card mapper takes.";
    }
    if (look.shading && look.shading->asksWhatReaches())
        return "Light that tells depth is what only the software ray caster has.";
    if (look.mode == RenderMode::direct && look.mixing.share > 0.0)
        return "Mixed modes are what only the software ray caster has.";
    if (look.brightness != 1.0) return "A picture of another brightness is what only the software ray caster has.";
    if (look.cutSurface) return "A curved cut is what only the software ray caster has.";
    return {};
}

void GraphicsCardVolume::setLook(const RayCastSettings& look, vtkVolumeProperty& transfer) {
    if (!m_volume) return;
    const double unit = m_volume->geometry().unit();
    m_mapper->SetSampleDistance(static_cast<float>(look.step * unit));
    if (m_mapper->GetBlendMode() != blendModeOf(look.mode)) m_mapper->SetBlendMode(blendModeOf(look.mode));
    m_shader.set(*m_prop->GetShaderProperty(), *m_volume, look);
    setPlanes(look);
    setBox(look);

    m_property->SetColor(transfer.GetRGBTransferFunction());
    if (look.mode == RenderMode::direct) {
        m_property->SetScalarOpacity(transfer.GetScalarOpacity());
    } else {
        // VTK weights the samples of these modes by the curve. castRays() does not.
        m_property->SetScalarOpacity(m_opaque);
    }
    m_property->SetScalarOpacityUnitDistance(unit);
    if (look.interpolation == Interpolation::nearest) {
        m_property->SetInterpolationTypeToNearest();
    } else {
        m_property->SetInterpolationTypeToLinear();
    }
}

void GraphicsCardVolume::setPlanes(const RayCastSettings& look) {
    std::vector<ClippingPlane> planes = look.clippingPlanes;
    if (look.front) planes.push_back({look.front->inwards * look.front->depthMm, look.front->inwards});
    // VTK composes its shader anew for another collection, but not if planes only move.
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

bool GraphicsCardVolume::fits(vtkOpenGLRenderWindow& window) {
    if (m_checked) return true;
    const auto& size = m_volume->geometry().size;
    vtkNew<vtkTextureObject> probe;
    probe->SetContext(&window);
    const int type =
        std::visit([](const auto& voxels) { return vtkTypeOf<typename std::decay_t<decltype(voxels)>::value_type>(); },
                   m_volume->voxels());
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

}  // namespace echolucent
