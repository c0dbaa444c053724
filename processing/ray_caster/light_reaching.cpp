#include "processing/ray_caster/light_reaching.h"

#include <chrono>

namespace echolucent::ray_casting {

bool LightReaching::update(const OpacityCurve& curve, const RayCastSettings& settings, const Progress& progress) {
    m_milliseconds = 0.0;
    if (settings.mode != RenderMode::direct || !settings.shading || !settings.shading->asksWhatReaches()) {
        m_packed.reset();
        return true;
    }
    LightScene scene = lightSceneOf(settings);
    scene.keyHalfAngleDegrees = settings.shading->keyHalfAngleDegrees;
    scene.coarseness = settings.lightCoarseness;
    if (m_packed && m_curve == curve && m_scene == scene) return true;
    m_packed.reset();
    const auto begin = std::chrono::steady_clock::now();
    const auto light = m_sweep.lightVolume(curve, scene, progress);
    if (!light) return false;
    m_packed.emplace(*light, m_sweep.volume()->geometry());
    m_curve = curve;
    m_scene = scene;
    m_milliseconds = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
    return true;
}

}  // namespace echolucent::ray_casting
