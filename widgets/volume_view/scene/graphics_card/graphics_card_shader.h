// Adds to the shader of VTK's GPU mapper what castRays() does to a sample's colour and the mapper does not.
#pragma once

#include <optional>

#include "processing/picture/ray_cast_settings.h"
#include "processing/volume/volume.h"

class vtkShaderProperty;

namespace echolucent {

/// Light, depth colouring, and the colour of a ray without samples. VTK's own shading stays off: its light knows no
/// share of surface, no shadow tint and no reach of the gradient, and it turns speckle into snow.
class GraphicsCardShader {
public:
    /// Sets the parts of a shader that a look needs. VTK composes its shader anew only for another kind of look. Light,
    /// tints and camera are plain parameters.
    void set(vtkShaderProperty& shader, const Volume& volume, const RayCastSettings& look);

private:
    struct Kind {
        RenderMode mode = RenderMode::direct;
        bool shaded = false, depthColoured = false, masked = false;
        friend bool operator==(const Kind&, const Kind&) = default;
    };
    static void setSource(vtkShaderProperty& shader, const Kind& kind);

    std::optional<Kind> m_kind;
};

}  // namespace echolucent
