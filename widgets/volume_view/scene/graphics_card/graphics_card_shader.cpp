#include "widgets/volume_view/scene/graphics_card/graphics_card_shader.h"

#include <vtkShaderProperty.h>
#include <vtkUniforms.h>

#include <algorithm>
#include <array>
#include <string>

#include "processing/picture/view_limits.h"

namespace echolucent {

namespace {

// VTK calls this for the colour of every sample; in_..., ip_... and g_... are its own names.
constexpr const char* sampleColour = R"(
vec3 computeRayDirection();
float sampleAtVoxel(vec3 voxel, vec3 size) {
    vec3 at = (in_cellToPoint[0] * vec4((voxel + 0.5) / size, 1.0)).xyz;
    return texture3D(in_volume[0], at).r * in_volume_scale[0].r + in_volume_bias[0].r;
}
bool hasDataAtVoxel(vec3 voxel, vec3 size) {
#ifdef ECHOLUCENT_MASKED
    return texture3D(in_mask, (voxel + 0.5) / size).r > 0.0;
#else
    return true;
#endif
}
// Normalised intensity per unit, as Shading says.
vec3 gradientHere() {
    vec3 size = vec3(textureSize(in_volume[0], 0)), here = clamp(g_dataPos * size - 0.5, vec3(0.0), size - 1.0);
    vec3 gradient = vec3(0.0);
    for (int axis = 0; axis < 3; ++axis) {
        vec3 before = here, after = here;
        before[axis] = max(here[axis] - ecReachVoxels[axis], 0.0);
        after[axis] = min(here[axis] + ecReachVoxels[axis], size[axis] - 1.0);
        if (!hasDataAtVoxel(before, size) || !hasDataAtVoxel(after, size)) return vec3(0.0);
        float units = (after[axis] - before[axis]) * ecUnitsPerVoxel[axis];
        if (units > 0.0) gradient[axis] = (sampleAtVoxel(after, size) - sampleAtVoxel(before, size)) / units;
    }
    return gradient * (in_scalarsRange[0].y - in_scalarsRange[0].x) / ecWhite;
}
vec3 litColour(vec3 colour) {
    vec3 gradient = gradientHere();
    float square = dot(gradient, gradient);
    float surface = square > 0.0 ? square / (square + ecGradientFloor * ecGradientFloor) : 0.0;
    vec3 normal = square > 0.0 ? -gradient * inversesqrt(square) : vec3(0.0);
    vec3 between = ecTowardsLight - computeRayDirection();
    vec3 halfway = dot(between, between) > 0.0 ? normalize(between) : vec3(0.0);
    float reached = max(0.0, (dot(normal, ecTowardsLight) + ecWrap) / (1.0 + ecWrap));
    float highlight = pow(max(1e-6, dot(normal, halfway)), ecSpecularPower);
    float factor = ecAmbient + ecDiffuse * (surface * reached + (1.0 - surface) * ecEvenLight) +
                   surface * ecSpecular * highlight;
    return min(vec3(1.0), colour * factor * (ecShadowTint + (1.0 - ecShadowTint) * min(1.0, factor)));
}
vec3 depthColour(vec3 colour) {
    float depth = dot((in_textureDatasetMatrix[0] * vec4(g_dataPos, 1.0)).xyz, ecForward);
    return colour * mix(ecNearTint, ecFarTint, clamp((depth - ecNearDepth) / (ecFarDepth - ecNearDepth), 0.0, 1.0));
}
vec4 computeLighting(vec4 color, int component, float label) {
    vec3 colour = color.rgb;
#ifdef ECHOLUCENT_SHADED
    colour = litColour(colour);
#endif
#ifdef ECHOLUCENT_DEPTH_COLOURED
    colour = depthColour(colour);
#endif
    return vec4(colour, color.a);
}
)";

// VTK shows the mean in grey, whatever the colour map.
constexpr const char* meanColour = R"(
if (l_numSamples.x == uint(0)) discard;
g_srcColor = computeColor(vec4(l_avgValue.x / float(l_numSamples.x)), 1.0);
g_fragColor = vec4(g_srcColor.rgb, 1.0);
)";

// For a ray without a sample VTK shows the colour of 0 or of white.
constexpr const char* extremeOfNothing = "if (l_firstValue) discard;\n//VTK::Shading::Exit";

void replace(vtkShaderProperty& shader, const char* place, const std::string& source) {
    constexpr bool beforeVtk = true, everywhere = false;
    shader.AddFragmentShaderReplacement(place, beforeVtk, source, everywhere);
}

void setVector(vtkUniforms& uniforms, const char* name, const Vec3& value) {
    const std::array<float, 3> floats{static_cast<float>(value[0]), static_cast<float>(value[1]),
                                      static_cast<float>(value[2])};
    uniforms.SetUniform3f(name, floats.data());
}

void setNumber(vtkUniforms& uniforms, const char* name, double value) {
    uniforms.SetUniformf(name, static_cast<float>(value));
}

void setLight(vtkUniforms& uniforms, const Volume& volume, const RayCastSettings& look, const Shading& shading) {
    const VolumeGeometry& geometry = volume.geometry();
    const ViewFrame& frame = look.camera.frame;
    const Vec3& light = shading.towardsLight;
    const Vec3 unitsPerVoxel = geometry.spacing * (1.0 / geometry.unit());
    setVector(uniforms, "ecTowardsLight",
              normalized(frame.right * light[0] + frame.down * light[1] + frame.forward * light[2]));
    setVector(uniforms, "ecShadowTint", shadowTintOf(look.colourMap));
    setVector(uniforms, "ecUnitsPerVoxel", unitsPerVoxel);
    setVector(uniforms, "ecReachVoxels",
              {shading.gradientReach / unitsPerVoxel[0], shading.gradientReach / unitsPerVoxel[1],
               shading.gradientReach / unitsPerVoxel[2]});
    setNumber(uniforms, "ecWhite", volume.whiteLevel());
    setNumber(uniforms, "ecAmbient", shading.ambient);
    setNumber(uniforms, "ecDiffuse", shading.diffuse);
    setNumber(uniforms, "ecSpecular", shading.specular);
    setNumber(uniforms, "ecSpecularPower", shading.specularPower);
    setNumber(uniforms, "ecGradientFloor", shading.gradientFloor);
    setNumber(uniforms, "ecWrap", shading.wrap);
    setNumber(uniforms, "ecEvenLight", shading.evenLight);
}

}  // namespace

void GraphicsCardShader::set(vtkShaderProperty& shader, const Volume& volume, const RayCastSettings& look) {
    const bool direct = look.mode == RenderMode::direct;
    const Kind kind{look.mode, direct && look.shading, direct && look.depthColouring, !volume.dataMask().empty()};
    vtkUniforms& uniforms = *shader.GetFragmentCustomUniforms();
    if (m_kind != kind) {
        setSource(shader, kind);
        // Set all parameters, whichever parts use them, because undeclared names are errors in GLSL.
        setLight(uniforms, volume, look, Shading{});
        m_kind = kind;
    }
    if (kind.shaded) setLight(uniforms, volume, look, *look.shading);
    const DepthColouring tints = look.depthColouring.value_or(DepthColouring{});
    const double nearest = nearestDepthMm(look, volume.geometry());
    const double farthest = volume.geometry().depthsAlong(look.camera.frame.forward).farthest;
    setVector(uniforms, "ecForward", look.camera.frame.forward);
    setVector(uniforms, "ecNearTint", tints.nearTint);
    setVector(uniforms, "ecFarTint", tints.farTint);
    setNumber(uniforms, "ecNearDepth", nearest);
    setNumber(uniforms, "ecFarDepth", std::max(farthest, nearest + 1e-6));
}

void GraphicsCardShader::setSource(vtkShaderProperty& shader, const Kind& kind) {
    shader.ClearAllShaderReplacements();
    if (kind.mode == RenderMode::mean) replace(shader, "//VTK::Shading::Exit", meanColour);
    if (kind.mode == RenderMode::maximum || kind.mode == RenderMode::minimum) {
        replace(shader, "//VTK::Shading::Exit", extremeOfNothing);
    }
    if (!kind.shaded && !kind.depthColoured) return;
    std::string source;
    if (kind.masked) source += "#define ECHOLUCENT_MASKED\n";
    if (kind.shaded) source += "#define ECHOLUCENT_SHADED\n";
    if (kind.depthColoured) source += "#define ECHOLUCENT_DEPTH_COLOURED\n";
    replace(shader, "//VTK::ComputeLighting::Dec", source + sampleColour);
}

}  // namespace echolucent
