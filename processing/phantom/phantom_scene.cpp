#include "processing/phantom/phantom_scene.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace echolucent {

namespace {

/// A wall of tissue before all else: 20 to 25 units thick, but in the mean at most a fifth of the depth.
void addFrontWall(PhantomScenery& scenery, const VolumeGeometry& geometry) {
    const double depth = geometry.boxMaxMm()[2] - geometry.boxMinMm()[2];
    const double scale = std::min(geometry.unit(), depth / 5 / 22.5);
    PhantomLayer wall;
    wall.material = PhantomMaterial::tissue;
    wall.echo = scenery.tissueEcho;
    wall.body.join(
        wavyPlane("front wall", {0, 0, geometry.boxMinMm()[2] + 22.5 * scale}, {0, 0, 1}, 2 * scale, 80 * scale));
    scenery.layers.push_back(std::move(wall));
}

void require(bool holds, const char* what) {
    if (!holds) throw std::invalid_argument(what);
}

}  // namespace

std::string_view nameOf(PhantomMaterial material) {
    switch (material) {
        case PhantomMaterial::fluid: return "fluid";
        case PhantomMaterial::tissue: return "tissue";
        case PhantomMaterial::object: break;
    }
    return "object";
}

VolumeGeometry phantomGeometry(const PhantomConfig& config) {
    for (int axis = 0; axis < 3; ++axis) {
        require(config.size[axis] >= 1, "phantom: every size must be at least 1");
        require(std::isfinite(config.spacing[axis]) && config.spacing[axis] > 0, "phantom: spacing must be above 0");
    }
    require(config.bits == 8 || config.bits == 12 || config.bits == 16, "phantom: bits must be 8, 12 or 16");
    require(config.ramp >= 0 && config.speckle >= 0 && config.speckleSize >= 0 && config.attenuation >= 0 &&
                config.shadow >= 0 && config.specular >= 0 && config.logCompressDecibel >= 0,
            "phantom: lengths, shares and losses must not be negative");
    require(config.speckleSize <= 64, "phantom: speckle larger than 64 voxels");
    VolumeGeometry geometry;
    geometry.size = config.size;
    geometry.spacing = config.spacing;
    return geometry;
}

double inverseRampPerMm(const PhantomConfig& config) {
    const double unit = std::min({config.spacing[0], config.spacing[1], config.spacing[2]});
    return 1 / std::max(config.ramp * unit, 1e-9 * unit);
}

Placement sceneryPose(const VolumeGeometry& geometry) {
    const Vec3 low = geometry.boxMinMm(), extent = geometry.boxMaxMm() - low;
    Placement placement;
    placement.scale = std::min({extent[0], extent[1], extent[2]});
    placement.origin = low + Vec3(0.5 * (extent[0] - placement.scale), 0.5 * (extent[1] - placement.scale), 0);
    return placement;
}

PhantomScenery buildScenery(const PhantomConfig& config) {
    const VolumeGeometry geometry = phantomGeometry(config);
    PhantomScenery scenery;
    scenery.tissueEcho = config.tissue;
    if (config.scene == PhantomScene::shapes) addShapes(scenery, sceneryPose(geometry), config);
    if (config.scene == PhantomScene::fetus) addFetus(scenery, sceneryPose(geometry), config);
    if (config.frontWall && config.scene != PhantomScene::empty) addFrontWall(scenery, geometry);
    return scenery;
}

}  // namespace echolucent
