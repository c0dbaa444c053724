#include <algorithm>
#include <utility>

#include "app/measuring/light/study_light.h"
#include "app/measuring/run_time.h"
#include "processing/median.h"

namespace echolucent::cli {

namespace {

/// A curve that looks like the given one and is not equal to it.
OpacityCurve changed(const OpacityCurve& curve, int turn) {
    std::vector<double> opacities = sampledOpacities(curve, 256);
    opacities.back() = std::max(0.0, opacities.back() - 1e-6 * (turn + 1));
    return SampledCurve{std::move(opacities)};
}

/// All variants take turns. Each turn changes all directions a little, so that no earlier result can be used again.
void timeAll(const LightCase& one, std::vector<LightResult>& results, int repeats) {
    std::vector<std::vector<double>> all(results.size()), turned(results.size()), key(results.size());
    LightSweep sweep(one.volume);
    for (int turn = 0; turn < repeats; ++turn)
        for (std::size_t i = 0; i < results.size(); ++i) {
            LightScene scene = results[i].variant.scene;
            const OpacityCurve curve = changed(one.curve, turn);
            const auto run = [&] { (void)sweep.lightVolume(curve, scene); };
            scene.towardsKey[0] += 1e-3 * turn;
            all[i].push_back(millisecondsOf(run));
            scene.towardsViewer[0] += 1e-3;
            scene.towardsKey[0] += 1e-3;
            turned[i].push_back(millisecondsOf(run));
            scene.towardsKey[0] += 1e-3;
            key[i].push_back(millisecondsOf(run));
        }
    for (std::size_t i = 0; i < results.size(); ++i) {
        results[i].milliseconds = medianOf(all[i]);
        results[i].turnedMilliseconds = medianOf(turned[i]);
        results[i].keyMilliseconds = medianOf(key[i]);
    }
}

Picture pictureOf(const LightCase& one, const light::Reaching& reaching) {
    return *light::castRaysInLight(*one.volume, one.curve, one.settings, reaching);
}

}  // namespace

std::vector<LightVariant> lightVariants(const LightScene& usual) {
    using light::DirectionRule;
    std::vector<LightVariant> variants{{"default", "", usual}};
    const auto add = [&](const std::string& parameter, const std::string& value, const auto& change) {
        LightScene scene = usual;
        change(scene);
        if (!(scene == usual)) variants.push_back({parameter, value, scene});
    };
    for (const int coarseness : {1, 2, 3, 4, 6})
        add("coarseness", std::to_string(coarseness), [&](LightScene& scene) { scene.coarseness = coarseness; });
    for (const auto rule : {DirectionRule::one, DirectionRule::four, DirectionRule::seven, DirectionRule::twelve}) {
        const std::string count = std::to_string(static_cast<int>(rule));
        add("key directions", count, [&](LightScene& scene) { scene.keyDirections = rule; });
        add("directions around", count, [&](LightScene& scene) { scene.aroundDirections = rule; });
    }
    return variants;
}

LightStudy measureLight(const LightCase& one, int repeats, int rings) {
    LightStudy study;
    study.name = one.name;
    const LightScene usual = lightSceneOf(one.settings, one.volume->geometry());
    const light::ReferenceLight reference(*one.volume, one.curve, usual, rings);
    study.referenceSeconds =
        1e-3 * millisecondsOf(
                   [&] { study.reference = pictureOf(one, [&](const Vec3& place) { return reference.at(place); }); });
    study.withoutReaching = pictureError(pictureOf(one, [](const Vec3&) { return ReachingShares{}; }), study.reference);
    LightSweep sweep(one.volume);
    for (const LightVariant& variant : lightVariants(usual)) {
        const LightVolume light = *sweep.lightVolume(one.curve, variant.scene);
        Picture picture = pictureOf(one, [&](const Vec3& place) { return reachingAt(light, place); });
        study.results.push_back({variant, pictureError(picture, study.reference)});
        if (study.results.size() == 1) study.usual = std::move(picture);
    }
    timeAll(one, study.results, repeats);
    return study;
}

}  // namespace echolucent::cli
