// The volume as VTK's GPU mapper draws it: as near as that mapper can come to the software ray caster's picture.
#pragma once

#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <memory>
#include <string>

#include "processing/picture/ray_cast_settings.h"
#include "processing/volume/volume.h"
#include "widgets/volume_view/scene/graphics_card/graphics_card_shader.h"

class vtkOpenGLGPUVolumeRayCastMapper;
class vtkObject;
class vtkOpenGLRenderWindow;
class vtkPiecewiseFunction;
class vtkPlaneCollection;
class vtkRenderer;
class vtkVolume;
class vtkVolumeProperty;

namespace echolucent {

/// Draws one volume through OpenGL with the renderer's camera. It has the same box as castRays() (half a voxel beyond
/// the outermost voxel centres), and the same step, interpolation, near cut, cropping, clipping planes, modes, curve,
/// light and depth colouring. It differs in this: samples are counted from where each ray enters the box; rays end at
/// an opacity of 254/255; a sample is transparent if its nearest voxel has no data; opacity is not pre-integrated;
/// nothing is written into the depth buffer.
class GraphicsCardVolume {
public:
    GraphicsCardVolume();
    ~GraphicsCardVolume();
    GraphicsCardVolume(const GraphicsCardVolume&) = delete;
    GraphicsCardVolume& operator=(const GraphicsCardVolume&) = delete;

    /// Shows a volume; null draws nothing. A volume with a data mask is copied once, others are not.
    void setVolume(std::shared_ptr<const Volume> volume);
    /// Curve and colours come from the property of the scene's volume. Pickers read it too.
    void setLook(const RayCastSettings& look, vtkVolumeProperty& transfer);

    void draw(vtkRenderer& renderer, vtkOpenGLRenderWindow& window);

    /// A sentence that says why the last drawing failed; empty if it did not. Kept until the next setVolume().
    [[nodiscard]] const std::string& failure() const { return m_failure; }
    /// The time of the last drawing, OpenGL's own work included.
    [[nodiscard]] double milliseconds() const;

    /// A sentence that says why a look cannot be drawn this way; empty if it can.
    [[nodiscard]] static std::string whyNot(const RayCastSettings& look);

private:
    void setPlanes(const RayCastSettings& look);
    void setBox(const RayCastSettings& look);
    void noteError(vtkObject* caller, unsigned long event, void* text);
    bool fits(vtkOpenGLRenderWindow& window);

    std::shared_ptr<const Volume> m_volume;
    bool m_checked = false;  // whether it was checked that the volume fits
    std::string m_failure;
    vtkNew<vtkOpenGLGPUVolumeRayCastMapper> m_mapper;
    vtkNew<vtkVolume> m_prop;
    vtkNew<vtkVolumeProperty> m_property;
    vtkNew<vtkPiecewiseFunction> m_opaque;
    vtkSmartPointer<vtkPlaneCollection> m_planes;
    GraphicsCardShader m_shader;
};

}  // namespace echolucent
