#include "processing/ray_caster/light_reaching.h"

#include <chrono>

namespace echolucent::ray_casting {

bool LightReaching::update(const LightOtf& otf, const RayCastSettings& settings, const Progress& progress) {
    m_milliseconds = 0.0;
    if (settings.mode != RenderMode::direct || !settings.shading || !settings.shading->asksWhatReaches()) {
        m_packed.reset();
        return true;
    }
    const LightScene scene = lightSceneOf(settings, m_volume->geometry());
    if (m_packed && m_classification == otf.classification && m_scene == scene) return true;
    m_packed.reset();
    const auto begin = std::chrono::steady_clock::now();
    if (!m_sweep) m_sweep.emplace(m_volume);
    const auto light = m_sweep->lightVolume(otf, scene, progress);
    if (!light) return false;
    m_packed.emplace(*light, m_volume->geometry());
    m_classification = otf.classification;
    m_scene = scene;
    m_milliseconds = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
    return true;
}

}  // namespace echolucent::ray_casting
