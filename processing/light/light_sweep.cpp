#include "processing/light/light_sweep.h"

#include "processing/light/light_grid.h"

namespace echolucent {

LightScene lightSceneOf(const RayCastSettings& settings) {
    const ViewFrame& frame = settings.camera.frame;
    const Vec3 light = settings.shading.value_or(Shading{}).towardsLight;
    LightScene scene;
    scene.towardsKey = frame.right * light[0] + frame.down * light[1] + frame.forward * light[2];
    scene.towardsViewer = -frame.forward;
    scene.rendered = {frame.forward, settings.nearPlaneDepthMm, settings.box, settings.clippingPlanes};
    return scene;
}

int coarsenessWithin(const VolumeGeometry& geometry, int finest, std::int64_t places) {
    constexpr int coarsest = 16;
    int coarseness = finest;
    while (coarseness<coarsest&& static_cast<std::int64_t>(light::LightGrid(geometry, coarseness).places())> places)
        ++coarseness;
    return coarseness;
}

class LightSweep::Parts {
public:
    std::shared_ptr<const Volume> volume;
};

LightSweep::LightSweep(std::shared_ptr<const Volume> volume) : m_parts(new Parts{std::move(volume)}) {}
LightSweep::~LightSweep() = default;
LightSweep::LightSweep(LightSweep&&) noexcept = default;
LightSweep& LightSweep::operator=(LightSweep&&) noexcept = default;
const std::shared_ptr<const Volume>& LightSweep::volume() const { return m_parts->volume; }

/// All light reaches every place until the sweeps stand here.
std::optional<LightVolume> LightSweep::lightVolume(const OpacityCurve&, const LightScene& scene, const Progress&) {
    const light::LightGrid grid(m_parts->volume->geometry(), scene.coarseness);
    LightVolume light{grid.size, grid.firstMm, grid.spacingMm, {}};
    light.reaching.assign(grid.places() * 2, 255);
    return light;
}

}  // namespace echolucent
