// What castRays() does to a sample's colour and VTK's GPU mapper does not, put into that mapper's shader.
#pragma once

#include <optional>

#include "processing/picture/ray_cast_settings.h"
#include "processing/volume/volume.h"

class vtkShaderProperty;

namespace echolucent {

/// Light, depth colouring and what a ray without samples shows. VTK's own shading stays off: its light knows no share
/// of surface, no shadow tint and no reach of the gradient, and speckle becomes snow under it.
class GraphicsCardShader {
public:
    /// Sets the parts of a shader that a look needs. Only another kind of look makes VTK compose its shader anew;
    /// light, tints and camera are plain parameters.
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
