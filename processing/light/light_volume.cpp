#include "processing/light/light_volume.h"

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
    const VolumeGeometry& geometry = m_parts->volume->geometry();
    LightVolume light;
    std::size_t places = 1;
    for (int axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<std::size_t>(axis);
        light.size[i] = static_cast<int>((geometry.size[i] + scene.coarseness - 1) / scene.coarseness);
        light.spacingMm[axis] = geometry.spacing[axis] * scene.coarseness;
        light.firstMm[axis] = geometry.spacing[axis] * 0.5 * (scene.coarseness - 1);
        places *= static_cast<std::size_t>(light.size[i]);
    }
    light.reaching.assign(places * 2, 255);
    return light;
}

}  // namespace echolucent
