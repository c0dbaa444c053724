#include "processing/picture/look.h"

#include <array>
#include <cmath>

#include "processing/parameters/parameter_rows.h"
#include "processing/picture/reaching_light.h"

namespace echolucent {

namespace {

/// The mode of the picture. If the mixed mode hides the direct mode completely, the mixed mode is cast alone.
RenderMode seenMode(const Look& look) {
    return look.mode == RenderMode::direct && look.mixing >= 1.0 ? look.mixedMode : look.mode;
}

namespace look_rows {

using namespace parameter_rows;

constexpr std::string_view byLooking = "chosen by looking";

template <auto value>
const Choice<decltype(value)> labelled(std::string_view label = {}) {
    return {value, nameOf(value), label};
}

const std::array modes{labelled<RenderMode::direct>("Direct rendering"), labelled<RenderMode::maximum>(),
                       labelled<RenderMode::minimum>(), labelled<RenderMode::mean>("Mean (x-ray)")};
const std::array mixedModes{labelled<RenderMode::maximum>(), labelled<RenderMode::mean>("Mean (x-ray)")};
const std::array reductions{labelled<SpeckleReduction::off>(), labelled<SpeckleReduction::light>(),
                            labelled<SpeckleReduction::medium>(), labelled<SpeckleReduction::strong>()};
const std::array lightings{labelled<Lighting::flat>(), labelled<Lighting::surface>(), labelled<Lighting::depth>()};
const std::array colourMaps{labelled<ColourMap::sepia>(), labelled<ColourMap::grey>(), labelled<ColourMap::ice>()};
const std::array projections{labelled<Projection::parallel>(), labelled<Projection::perspective>()};
const std::array interpolations{labelled<Interpolation::trilinear>(),
                                labelled<Interpolation::nearest>("Nearest voxel")};

bool isDirect(const Look& look) { return seenMode(look) == RenderMode::direct; }
bool hasLight(const Look& look) { return isDirect(look) && look.lighting != Lighting::flat; }
bool hasReachingLight(const Look& look) { return isDirect(look) && look.lighting == Lighting::depth; }
bool hasShadows(const Look& look) { return hasReachingLight(look) && look.reaching.shadow > 0.0; }
bool canMix(const Look& look) { return look.mode == RenderMode::direct; }
bool mixes(const Look& look) { return canMix(look) && look.mixing > 0.0; }

constexpr std::string_view inDirectMode = "in direct mode";
constexpr std::string_view withLight = "in direct mode with light";
constexpr std::string_view withReachingLight = "in direct mode with light that tells depth";

ParameterTable<Look> lookTable() {
    return {
        {
            choice<modes, &Look::mode>({"mode", "Mode",
                                        "What a ray shows of the volume; the opacity curve, light and depth colours "
                                        "play a part in direct mode only",
                                        "", "Petersch 2005, eqs. 2 and 3 (direct)"}),
            playing(canMix, inDirectMode,
                    number<&Look::mixing>({"mixing", "Mixed in",
                                           "How much of the mixed mode is seen in the picture: none of it, up to "
                                           "nothing else",
                                           "", byLooking},
                                          {0, 1})),
            playing(mixes, "in direct mode if something is mixed in",
                    choice<mixedModes, &Look::mixedMode>({"mixed_mode", "Mixed mode",
                                                          "What is mixed into the picture, along the same rays", "",
                                                          byLooking})),
            choice<reductions, &Look::reduction>(
                {"reduction", "Smoothing", "How much the grain of speckle is smoothed away before the picture is made",
                 "", "docs/speckle.md; chosen by looking"}),
            playing(isDirect, inDirectMode,
                    choice<lightings, &Look::lighting>(
                        {"lighting", "Kind of light",
                         "What light does: nothing, fall on surfaces, or fall on them as far as it reaches them", "",
                         "Shading in processing/picture/shading.h; chosen by looking"})),
            playing(hasLight, withLight,
                    number<&Look::light, &LightDirection::azimuthDegrees>(
                        {"light_azimuth", "Azimuth of the light", "How far to the right of the viewer the light stands",
                         "degrees", byLooking},
                        {-180, 180})),
            playing(hasLight, withLight,
                    number<&Look::light, &LightDirection::elevationDegrees>(
                        {"light_elevation", "Elevation of the light", "How far above the viewer the light stands",
                         "degrees", byLooking},
                        {-90, 90})),
            playing(hasShadows, "in direct mode with light that tells depth and shadows",
                    number<&Look::lightSoftness>({"light_softness", "Softness of the light",
                                                  "Half the angle under which the light is seen: the softer the "
                                                  "light, the softer its shadows",
                                                  "degrees", byLooking},
                                                 {0, 45})),
            playing(hasReachingLight, withReachingLight,
                    number<&Look::reaching, &ReachingLight::shadow>(
                        {"shadow", "Cast shadows", "How dark it is where the light does not reach", "", byLooking},
                        {0, 1})),
            playing(hasReachingLight, withReachingLight,
                    number<&Look::reaching, &ReachingLight::occlusion>(
                        {"occlusion", "Dark hollows", "How dark it is where the light around the viewer does not reach",
                         "", byLooking},
                        {0, 1})),
            playing(hasShadows, "in direct mode with light that tells depth and shadows",
                    number<&Look::reaching, &ReachingLight::translucency>(
                        {"translucency", "Translucency", "How warm light becomes on its way through thin tissue", "",
                         byLooking},
                        {0, 1})),
            playing(isDirect, inDirectMode,
                    flag<&Look::depthColoured>({"depth_colouring", "Depth colours",
                                                "Tints what is near warm and what is far blue", "",
                                                "DepthColouring in processing/picture/shading.h"})),
            choice<colourMaps, &Look::colourMap>(
                {"colour_map", "Colour map", "Colours from dark to bright echoes", "", byLooking}),
            number<&Look::brightness>(
                {"brightness", "Brightness", "How bright the picture is: a factor on its colours", "times", byLooking},
                {0.25, 4}),
            choice<projections, &Look::projection>(
                {"projection", "Projection", "Parallel keeps sizes, perspective gives depth", "", byLooking}),
            choice<interpolations, &Look::interpolation>({"interpolation", "Interpolation",
                                                          "How intensities between voxels are taken", "",
                                                          "docs/cli-study.md, study render"}),
            // Not in panels: the quality of a window's picture sets its step.
            number<&Look::step>(
                {"step", "Step", "Distance between the samples on a ray; opacities are corrected for it", "units",
                 "docs/rendering.md, What errs, and by how much"},
                {1e-3, 100}, {.inPanels = false}),
        },
        lookAtStart()};
}

}  // namespace look_rows

}  // namespace

const ParameterTable<Look>& lookParameters() {
    static const ParameterTable<Look> table = look_rows::lookTable();
    return table;
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
