#include "processing/picture/look.h"

#include <array>
#include <cctype>
#include <cmath>

#include "processing/picture/reaching_light.h"

namespace echolucent {

namespace {

constexpr std::string_view byLooking = "chosen by looking";

/// Takes a number from a value where it holds one.
bool setNumber(double& number, const ParameterValue& value) {
    const std::optional<double> given = numberOf(value);
    if (given) number = *given;
    return given.has_value();
}

template <auto member>
std::optional<ParameterValue> getFlag(const Look& look) {
    return look.*member;
}
template <auto member>
bool setFlag(Look& look, const ParameterValue& value) {
    const auto* flag = std::get_if<bool>(&value);
    if (flag != nullptr) look.*member = *flag;
    return flag != nullptr;
}

template <auto member>
std::optional<ParameterValue> getChoice(const Look& look) {
    return std::string(nameOf(look.*member));
}
template <auto member, auto fromName>
bool setChoice(Look& look, const ParameterValue& value) {
    const auto* name = std::get_if<std::string>(&value);
    const auto choice = name != nullptr ? fromName(*name) : std::nullopt;
    if (choice) look.*member = *choice;
    return choice.has_value();
}

/// Direct and minimum are never mixed in.
std::optional<RenderMode> mixedModeFromName(std::string_view name) {
    const auto mode = renderModeFromName(name);
    return mode == RenderMode::maximum || mode == RenderMode::mean ? mode : std::nullopt;
}

template <auto angle>
std::optional<ParameterValue> getAngle(const Look& look) {
    return look.light.*angle;
}
template <auto angle>
bool setAngle(Look& look, const ParameterValue& value) {
    return setNumber(look.light.*angle, value);
}

template <auto member>
std::optional<ParameterValue> getReaching(const Look& look) {
    return look.reaching.*member;
}
template <auto member>
bool setReaching(Look& look, const ParameterValue& value) {
    return setNumber(look.reaching.*member, value);
}

const std::array<Parameter<Look>, 17>& rows() {
    static const std::array<Parameter<Look>, 17> table{{
        {"mode",
         "Mode",
         "What a ray shows of the volume; the opacity curve, light and depth colours play a part in direct mode only",
         "",
         "Petersch 2005, eqs. 2 and 3 (direct)",
         {},
         {nameOf(RenderMode::direct), nameOf(RenderMode::maximum), nameOf(RenderMode::minimum),
          nameOf(RenderMode::mean)},
         &getChoice<&Look::mode>,
         &setChoice<&Look::mode, &renderModeFromName>},
        {"mixing",
         "Mixed in",
         "How much of the mixed mode is seen in the picture: none of it, up to nothing else",
         "",
         byLooking,
         {0, 1},
         {},
         [](const Look& look) { return std::optional<ParameterValue>(look.mixing); },
         [](Look& look, const ParameterValue& value) { return setNumber(look.mixing, value); }},
        {"mixed_mode",
         "Mixed mode",
         "What is mixed into the picture, along the same rays",
         "",
         byLooking,
         {},
         {nameOf(RenderMode::maximum), nameOf(RenderMode::mean)},
         &getChoice<&Look::mixedMode>,
         &setChoice<&Look::mixedMode, &mixedModeFromName>},
        {"reduction",
         "Speckle reduction",
         "How much speckle is taken out of the voxels that the picture is made of",
         "",
         "docs/speckle.md; chosen by looking",
         {},
         {nameOf(SpeckleReduction::off), nameOf(SpeckleReduction::light), nameOf(SpeckleReduction::medium),
          nameOf(SpeckleReduction::strong)},
         &getChoice<&Look::reduction>,
         &setChoice<&Look::reduction, &speckleReductionFromName>},
        {"lighting",
         "Light",
         "What light does: nothing, fall on surfaces, or fall on them as far as it reaches them",
         "",
         "Shading in processing/picture/shading.h; chosen by looking",
         {},
         {nameOf(Lighting::flat), nameOf(Lighting::surface), nameOf(Lighting::depth)},
         &getChoice<&Look::lighting>,
         &setChoice<&Look::lighting, &lightingFromName>},
        {"light_azimuth",
         "Azimuth of the light",
         "How far to the right of the viewer the light stands",
         "degrees",
         byLooking,
         {-180, 180},
         {},
         &getAngle<&LightDirection::azimuthDegrees>,
         &setAngle<&LightDirection::azimuthDegrees>},
        {"light_elevation",
         "Elevation of the light",
         "How far above the viewer the light stands",
         "degrees",
         byLooking,
         {-90, 90},
         {},
         &getAngle<&LightDirection::elevationDegrees>,
         &setAngle<&LightDirection::elevationDegrees>},
        {"light_softness",
         "Softness of the light",
         "Half the angle under which the light is seen: the softer the light, the softer its shadows",
         "degrees",
         byLooking,
         {0, 45},
         {},
         [](const Look& look) { return std::optional<ParameterValue>(look.lightSoftness); },
         [](Look& look, const ParameterValue& value) { return setNumber(look.lightSoftness, value); }},
        {"shadow",
         "Cast shadows",
         "How dark it is where the light does not reach",
         "",
         byLooking,
         {0, 1},
         {},
         &getReaching<&ReachingLight::shadow>,
         &setReaching<&ReachingLight::shadow>},
        {"occlusion",
         "Dark hollows",
         "How dark it is where the light around the viewer does not reach",
         "",
         byLooking,
         {0, 1},
         {},
         &getReaching<&ReachingLight::occlusion>,
         &setReaching<&ReachingLight::occlusion>},
        {"translucency",
         "Translucency",
         "How warm light becomes on its way through thin tissue",
         "",
         byLooking,
         {0, 1},
         {},
         &getReaching<&ReachingLight::translucency>,
         &setReaching<&ReachingLight::translucency>},
        {"depth_colouring",
         "Depth colours",
         "Tints what is near warm and what is far blue",
         "",
         "DepthColouring in processing/picture/shading.h",
         {},
         {},
         &getFlag<&Look::depthColoured>,
         &setFlag<&Look::depthColoured>},
        {"colour_map",
         "Colour map",
         "Colours from dark to bright echoes",
         "",
         byLooking,
         {},
         {nameOf(ColourMap::sepia), nameOf(ColourMap::grey), nameOf(ColourMap::ice)},
         &getChoice<&Look::colourMap>,
         &setChoice<&Look::colourMap, &colourMapFromName>},
        {"brightness",
         "Brightness",
         "How bright the picture is: a factor on its colours",
         "times",
         byLooking,
         {0.25, 4},
         {},
         [](const Look& look) { return std::optional<ParameterValue>(look.brightness); },
         [](Look& look, const ParameterValue& value) { return setNumber(look.brightness, value); }},
        {"projection",
         "Projection",
         "Parallel keeps sizes, perspective gives depth",
         "",
         byLooking,
         {},
         {nameOf(Projection::parallel), nameOf(Projection::perspective)},
         &getChoice<&Look::projection>,
         &setChoice<&Look::projection, &projectionFromName>},
        {"interpolation",
         "Interpolation",
         "How intensities between voxels are taken",
         "",
         "docs/cli-study.md, study render",
         {},
         {nameOf(Interpolation::trilinear), nameOf(Interpolation::nearest)},
         &getChoice<&Look::interpolation>,
         &setChoice<&Look::interpolation, &interpolationFromName>},
        {"step",
         "Step",
         "Distance between the samples on a ray; opacities are corrected for it",
         "units",
         "docs/rendering.md, What errs, and by how much",
         {1e-3, 100},
         {},
         [](const Look& look) { return std::optional<ParameterValue>(look.step); },
         [](Look& look, const ParameterValue& value) { return setNumber(look.step, value); }},
    }};
    return table;
}

}  // namespace

std::span<const Parameter<Look>> lookParameters() { return rows(); }

bool chosenByPersons(const Parameter<Look>& row) { return row.name != "step"; }

namespace {
/// A mode of which nothing is left is not cast.
RenderMode seenMode(const Look& look) {
    return look.mode == RenderMode::direct && look.mixing >= 1.0 ? look.mixedMode : look.mode;
}
}  // namespace

bool playsAPart(std::string_view name, const Look& look) {
    if (name == "mixing") return look.mode == RenderMode::direct;
    if (name == "mixed_mode") return look.mode == RenderMode::direct && look.mixing > 0.0;
    const bool direct = seenMode(look) == RenderMode::direct;
    if (name == "lighting" || name == "depth_colouring") return direct;
    if (name == "light_azimuth" || name == "light_elevation") return direct && look.lighting != Lighting::flat;
    const bool reaches = direct && look.lighting == Lighting::depth;
    if (name == "shadow" || name == "occlusion") return reaches;
    if (name == "light_softness" || name == "translucency") return reaches && look.reaching.shadow > 0.0;
    return true;
}

std::string labelOfChoice(std::string_view choice) {
    if (choice == nameOf(RenderMode::direct)) return "Direct rendering";
    if (choice == nameOf(RenderMode::mean)) return "Mean (x-ray)";
    if (choice == nameOf(Interpolation::nearest)) return "Nearest voxel";
    std::string label(choice);
    if (!label.empty()) label[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(label[0])));
    return label;
}

Look lookAtStart() {
    Look look;
    look.reduction = defaultSpeckleReduction;
    look.lighting = Lighting::depth;
    look.light = {std::round(look.light.azimuthDegrees), std::round(look.light.elevationDegrees)};
    return look;
}

RayCastSettings rayCastSettings(const Look& look) {
    RayCastSettings settings;
    settings.step = look.step;
    settings.interpolation = look.interpolation;
    settings.mode = seenMode(look);
    settings.colourMap = look.colourMap;
    settings.brightness = look.brightness;
    settings.camera.projection = look.projection;
    if (settings.mode != RenderMode::direct) return settings;
    if (look.mixing > 0.0) settings.mixing = {look.mixing, look.mixedMode};
    if (look.lighting != Lighting::flat) settings.shading = Shading{.towardsLight = towardsLight(look.light)};
    if (look.lighting == Lighting::depth) {
        settings.shading->ambient = ambientWithReachingLight;
        settings.shading->diffuse = diffuseWithReachingLight;
        settings.shading->keyHalfAngleDegrees = look.lightSoftness;
        settings.shading->reaching = look.reaching;
    }
    if (look.depthColoured) settings.depthColouring = DepthColouring{};
    return settings;
}

}  // namespace echolucent
