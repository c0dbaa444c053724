#include "widgets/volume_view/scene/graphics_card/card_uniforms.h"

#include <vtkShaderProgram.h>

#include <algorithm>
#include <array>
#include <vector>

#include "processing/picture/view_limits.h"
#include "processing/ray_caster/light_source.h"

namespace echolucent {

namespace {

using ray_casting::ColourRanges;
using ray_casting::LightSource;
using ray_casting::RayPlan;

/// Sets uniforms of a program. It knows them by the name in the shader; one that the shader does not read is no error.
class Uniforms {
public:
    explicit Uniforms(vtkShaderProgram& program) : m_program(program) {}

    void set(const char* name, double value) const {
        if (m_program.IsUniformUsed(name)) m_program.SetUniformf(name, static_cast<float>(value));
    }
    void set(const char* name, const Vec3& value) const {
        if (m_program.IsUniformUsed(name)) m_program.SetUniform3f(name, floats(value).data());
    }
    void set(const char* name, const std::array<float, 3>& value) const {
        if (m_program.IsUniformUsed(name)) m_program.SetUniform3f(name, value.data());
    }
    void set(const char* name, const std::vector<std::array<float, 3>>& values) const {
        if (m_program.IsUniformUsed(name))
            m_program.SetUniform3fv(name, static_cast<int>(values.size()), values.front().data());
    }
    void set(const char* name, const std::vector<std::array<float, 4>>& values) const {
        if (m_program.IsUniformUsed(name))
            m_program.SetUniform4fv(name, static_cast<int>(values.size()), values.front().data());
    }

private:
    static std::array<float, 3> floats(const Vec3& value) {
        return {static_cast<float>(value[0]), static_cast<float>(value[1]), static_cast<float>(value[2])};
    }
    vtkShaderProgram& m_program;
};

void setRays(const Uniforms& uniforms, const RayPlan& rays, const VolumeGeometry& geometry) {
    uniforms.set("first", rays.first);
    uniforms.set("perColumn", rays.perColumn);
    uniforms.set("perRow", rays.perRow);
    uniforms.set("low", rays.low);
    uniforms.set("high", rays.high);
    uniforms.set("spacing", geometry.spacing);
    uniforms.set("stepMm", rays.stepMm);
    uniforms.set("startDepth", rays.startDepth);
    uniforms.set("parallelWay", rays.step);
    uniforms.set("forward", rays.forward);
    uniforms.set("eye", rays.eye);
    uniforms.set("eyeDepth", rays.eyeDepth);
    uniforms.set("nearDepth", std::max(rays.nearDepth, -1e15));
    std::vector<std::array<float, 4>> spaces;
    for (const ray_casting::HalfSpace& space : rays.halfSpaces)
        spaces.push_back({static_cast<float>(space.normal[0]), static_cast<float>(space.normal[1]),
                          static_cast<float>(space.normal[2]), static_cast<float>(space.offset)});
    if (!spaces.empty()) uniforms.set("halfSpaces", spaces);
}

/// The shader knows places on the surface in nodes.
void setSurface(const Uniforms& uniforms, const CutSurface& surface) {
    uniforms.set("surfaceRight", surface.frame.right * (1.0 / surface.spacingMm));
    uniforms.set("surfaceDown", surface.frame.down * (1.0 / surface.spacingMm));
    uniforms.set("surfaceForward", surface.frame.forward);
    uniforms.set("surfaceFirst",
                 Vec3(surface.firstRightMm / surface.spacingMm, surface.firstDownMm / surface.spacingMm, 0.0));
}

void setVoxels(const Uniforms& uniforms, const CardPicture& picture) {
    const Volume& filled = picture.scan->filled;
    const auto& size = filled.geometry().size;
    uniforms.set("size",
                 Vec3(static_cast<double>(size[0]), static_cast<double>(size[1]), static_cast<double>(size[2])));
    // A texture of whole numbers gives them as shares of the largest one.
    const double texel = std::holds_alternative<VoxelArray<std::uint8_t>>(filled.voxels())    ? 255.0
                         : std::holds_alternative<VoxelArray<std::uint16_t>>(filled.voxels()) ? 65535.0
                                                                                              : 1.0;
    uniforms.set("toPosition", texel * static_cast<double>(picture.scan->toPosition));
    const ColourRanges& colours = picture.table->colours();
    std::vector<std::array<float, 3>> base, slope;
    for (std::size_t range = 0; range < ColourRanges::count; ++range) {
        base.push_back({colours.base[0][range], colours.base[1][range], colours.base[2][range]});
        slope.push_back({colours.slope[0][range], colours.slope[1][range], colours.slope[2][range]});
    }
    uniforms.set("colourBase", base);
    uniforms.set("colourSlope", slope);
    uniforms.set("firstVisible", picture.firstVisible);
    if (picture.bricks) {
        const auto& bricks = picture.bricks->size;
        uniforms.set("bricks", Vec3(static_cast<double>(bricks[0]), static_cast<double>(bricks[1]),
                                    static_cast<double>(bricks[2])));
    }
}

void setLight(const Uniforms& uniforms, const CardPicture& picture, const RayCastSettings& settings) {
    const VolumeGeometry& geometry = picture.scan->filled.geometry();
    const Shading& shading = *settings.shading;
    const LightSource source = ray_casting::lightSource(shading, geometry, settings.camera.frame, settings.colourMap);
    uniforms.set("towardsLight", source.towardsLight);
    uniforms.set("unitsPerVoxel", source.unitsPerVoxel);
    uniforms.set("reach", Vec3(source.reach[0], source.reach[1], source.reach[2]));
    uniforms.set("shadowTint", source.shadowTint);
    uniforms.set("ambient", source.ambient);
    uniforms.set("diffuse", source.diffuse);
    uniforms.set("evenLight", source.evenLight);
    uniforms.set("wrap", source.wrap);
    uniforms.set("floorSquare", source.floorSquare);
    uniforms.set("specular", shading.specular);
    uniforms.set("specularPower", shading.specularPower);
    uniforms.set("worthGradient", LightSource::worthGradient * std::min(1.0, settings.step));
    uniforms.set("shadow", source.shadow);
    uniforms.set("occlusion", source.occlusion);
    uniforms.set("translucency", source.translucency);
    if (!picture.light) return;
    const LightVolume& light = *picture.light;
    Vec3 perVoxel, first;
    for (int axis = 0; axis < 3; ++axis) {
        perVoxel[axis] = geometry.spacing[axis] / light.spacingMm[axis];
        first[axis] = -light.firstMm[axis] / light.spacingMm[axis];
    }
    uniforms.set("lightSize", Vec3(light.size[0], light.size[1], light.size[2]));
    uniforms.set("lightPerVoxel", perVoxel);
    uniforms.set("lightFirst", first);
}

void setTint(const Uniforms& uniforms, const CardPicture& picture, const RayCastSettings& settings) {
    const VolumeGeometry& geometry = picture.scan->filled.geometry();
    const DepthColouring& colouring = *settings.depthColouring;
    const double nearest = nearestDepthMm(settings, geometry);
    const double range = geometry.depthsAlong(settings.camera.frame.forward).farthest - nearest;
    uniforms.set("nearTint", colouring.nearTint);
    uniforms.set("tintChange", colouring.farTint - colouring.nearTint);
    uniforms.set("tintDepth", nearest);
    uniforms.set("tintPerMm", range > 0.0 ? 1.0 / range : 0.0);
}

}  // namespace

void setCardUniforms(vtkShaderProgram& program, const CardPicture& picture, const RayCastSettings& settings,
                     double weight) {
    const Uniforms uniforms(program);
    setRays(uniforms, picture.rays, picture.scan->filled.geometry());
    if (picture.surface) setSurface(uniforms, *picture.surface);
    setVoxels(uniforms, picture);
    uniforms.set("ends", settings.terminationTransmittance);
    uniforms.set("stepUnits", settings.step);
    uniforms.set("brightness", settings.brightness);
    uniforms.set("weight", weight);
    if (settings.mode != RenderMode::direct) return;
    if (settings.shading) setLight(uniforms, picture, settings);
    if (settings.depthColouring) setTint(uniforms, picture, settings);
}

}  // namespace echolucent
