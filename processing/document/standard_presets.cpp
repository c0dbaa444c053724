#include <array>

#include "processing/document/preset.h"

namespace echolucent {

namespace {

Preset inMode(std::string name, RenderMode mode) {
    Preset preset{.name = std::move(name)};
    preset.look.mode = mode;
    preset.look.colourMap = ColourMap::grey;
    return preset;
}

Preset asTheProgramStarts() { return {.name = "Standard"}; }

Preset softSkin() {
    Preset preset{.name = "Soft skin"};
    preset.look.reduction = SpeckleReduction::strong;
    preset.look.lightSoftness = 25;
    preset.look.reaching.translucency = 1;
    return preset;
}

Preset crispSurface() {
    Preset preset{.name = "Crisp surface"};
    preset.look.reduction = SpeckleReduction::light;
    preset.look.lighting = Lighting::surface;
    preset.curves.adjustment.transparency = -0.5;
    return preset;
}

Preset seeThrough() {
    Preset preset{.name = "See-through"};
    preset.look.lighting = Lighting::surface;
    preset.look.colourMap = ColourMap::ice;
    preset.look.depthColoured = true;
    preset.curves.adjustment.transparency = 1;
    return preset;
}

Preset surfaceAndBones() {
    Preset preset{.name = "Surface and bright echoes"};
    preset.look.mixing = 0.5;
    preset.look.mixedMode = RenderMode::maximum;
    return preset;
}

Preset slicerFetal() {
    Preset preset{.name = "Slicer's fetal curve", .curve = CurveKind::manual};
    preset.look.lighting = Lighting::surface;
    return preset;
}

Preset plainParabola() {
    Preset preset{.name = "Parabola, no light", .curve = CurveKind::parabolic};
    preset.look.reduction = SpeckleReduction::off;
    preset.look.lighting = Lighting::flat;
    return preset;
}

}  // namespace

std::span<const Preset> standardPresets() {
    static const std::array<Preset, 9> presets{asTheProgramStarts(),
                                               softSkin(),
                                               crispSurface(),
                                               seeThrough(),
                                               surfaceAndBones(),
                                               slicerFetal(),
                                               inMode("Bright echoes (maximum)", RenderMode::maximum),
                                               inMode("X-ray (mean)", RenderMode::mean),
                                               plainParabola()};
    return presets;
}

}  // namespace echolucent
