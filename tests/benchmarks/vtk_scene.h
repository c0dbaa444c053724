// VTK's own volume renderers on the same scene, in an off-screen window.
#pragma once

#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <memory>
#include <string>
#include <vector>

#include "processing/opacity_curve.h"
#include "processing/picture/ray_cast_settings.h"
#include "processing/volume/volume.h"
#include "tests/benchmarks/measured_cost.h"

class vtkRenderWindow;
class vtkRenderer;
class vtkVolume;
class vtkVolumeMapper;
class vtkVolumeProperty;

namespace echolucent::bench {

class StagedFixedPointMapper;

/// The cost of one frame of VTK's CPU mapper, by its stages.
struct VtkFrameCost {
    Cost setUp;  ///< matrices, and after a change: tables, gradients, shading table, min-max bricks
    Cost rays;   ///< the ray casting alone
    Cost frame;  ///< vtkRenderWindow::Render() as a whole: both, and the way through OpenGL
};

/// One renderer, one volume, in a window of size x size pixels that is never shown. The volume must outlive it.
class VtkScene {
public:
    enum class Renderer { fixedPoint, gpu };
    VtkScene(Renderer renderer, const Volume& volume, int size, int threads);
    ~VtkScene();
    VtkScene(const VtkScene&) = delete;
    VtkScene& operator=(const VtkScene&) = delete;

    /// Colours, opacities and light of the next frames. With `lit` VTK's own Blinn-Phong shading is on, with our
    /// material's numbers and a light from the same side.
    void setLook(const OpacityCurve& curve, const RayCastSettings& settings, bool lit);
    /// Draws through the camera of the settings, at their step. VTK's mapper counts whole steps from the near clipping
    /// plane. That plane is set so that VTK's sample planes are ours (parallel projection). shiftSteps moves VTK's
    /// planes by that share of a step.
    VtkFrameCost draw(const RayCastSettings& settings, double shiftSteps = 0.0);

    /// Red, green, blue over black, rows from the top. The CPU mapper's picture has 15 bits a channel, taken before
    /// OpenGL makes 8 of them. The GPU mapper's comes from the window, 8 bits.
    [[nodiscard]] std::vector<float> rgb() const;
    /// The name of the OpenGL renderer: "llvmpipe (LLVM 15.0.6, 256 bits)". Known after the first frame.
    [[nodiscard]] std::string openGlRenderer() const;

private:
    [[nodiscard]] std::vector<float> windowPixels() const;

    int m_size;
    VolumeGeometry m_geometry;
    const Volume& m_volume;
    vtkNew<vtkRenderWindow> m_window;
    vtkNew<vtkRenderer> m_renderer;
    vtkNew<vtkVolume> m_volumeProp;
    vtkNew<vtkVolumeProperty> m_property;
    vtkSmartPointer<vtkVolumeMapper> m_mapper;
    vtkSmartPointer<StagedFixedPointMapper> m_fixedPoint;  ///< null if the GPU's mapper is measured
};

}  // namespace echolucent::bench
