#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/measuring/render/study_render.h"
#include "app/measuring/run_time.h"
#include "processing/median.h"
#include "processing/ray_caster/ray_caster.h"

namespace echolucent::cli {

namespace {

constexpr double convergedStep = 0.1;
/// The camera turns between timed runs, so that no run uses kept samples of an unchanged view.
constexpr double hairDegrees = 0.01;
/// The plain route is slow, and its run times vary little compared with their distance from the kernel's.
constexpr int mostPlainRepeats = 3;

/// Turns the camera about the picture's vertical axis through the focal point.
Camera turned(Camera camera, double degrees) {
    const double angle = degrees * std::numbers::pi / 180.0;
    const ViewFrame frame = camera.frame;
    camera.frame.right = frame.right * std::cos(angle) - frame.forward * std::sin(angle);
    camera.frame.forward = frame.forward * std::cos(angle) + frame.right * std::sin(angle);
    return camera;
}

/// Casts the picture of a setting, not enlarged.
Picture castOnce(const RenderVariant& variant, const RenderCase& one, RayCaster& caster, double turnedDegrees) {
    RayCastSettings settings = variant.settings;
    settings.camera = turned(settings.camera, turnedDegrees);
    if (!variant.plain) return *caster.cast(one.curve, settings);
    return *castRaysPlainly(*one.volume, one.curve, settings, *variant.plain);
}

Picture convergedPicture(const RenderCase& one) {
    RayCastSettings settings = one.reference;
    settings.step = convergedStep;
    settings.terminationTransmittance = 0.0;
    return *castRaysPlainly(*one.volume, one.curve, settings);
}

std::string letterOf(std::size_t index) {
    std::string letters;
    for (std::size_t left = index + 1; left > 0; left = (left - 1) / 26)
        letters.insert(letters.begin(), static_cast<char>('A' + (left - 1) % 26));
    return letters;
}

/// The result of the plain route in double at these settings.
const RenderResult& inDouble(const std::vector<RenderResult>& results, const RayCastSettings& settings) {
    return *std::find_if(results.begin(), results.end(), [&](const RenderResult& result) {
        return result.variant.plain == asTheKernel(settings.step) && result.variant.settings == settings;
    });
}

void measureErrors(const RenderCase& one, RayCaster& caster, RenderStudy& study) {
    Picture plainInDouble;
    for (const RenderVariant& variant : renderVariants(one.reference)) {
        RenderResult result{variant, letterOf(study.results.size()), {}, std::nullopt};
        Picture picture = pictureOf(variant, one, caster);
        result.error = pictureError(picture, study.converged);
        if (variant.plain == asTheKernel(variant.settings.step)) plainInDouble = picture;
        if (variant.axis == "precision") result.precisionError = pictureError(picture, plainInDouble);
        study.results.push_back(std::move(result));
    }
}

/// Times the kernel's settings, then the plain ones. Every round runs all settings of a route once, every other round
/// backwards, so that other load on the machine meets them alike. An untimed run comes before each run of the kernel: a
/// moving hand casts many pictures of one setting, and the caster makes a setting's tables and its map of empty space
/// only once.
void measureTimes(const RenderCase& one, RayCaster& caster, RenderStudy& study) {
    const std::size_t count = study.results.size();
    std::vector<std::vector<double>> times(count);
    const auto runAll = [&](bool plain, int rounds) {
        for (int round = 0; round < rounds; ++round)
            for (std::size_t place = 0; place < count; ++place) {
                const std::size_t i = round % 2 == 0 ? place : count - 1 - place;
                const RenderVariant& variant = study.results[i].variant;
                if (variant.plain.has_value() != plain) continue;
                const double degrees = hairDegrees * (round + 1);
                if (!plain) (void)castOnce(variant, one, caster, -degrees);
                times[i].push_back(millisecondsOf([&] { (void)castOnce(variant, one, caster, degrees); }));
            }
    };
    runAll(false, study.repeats);
    runAll(true, study.plainRepeats);
    for (std::size_t i = 0; i < times.size(); ++i) study.results[i].milliseconds = medianOf(times[i]);
    // A coarse clock must not make the ratio infinite.
    constexpr double leastTime = 1e-6;
    for (RenderResult& result : study.results) {
        const RenderResult& unit =
            result.variant.plain ? inDouble(study.results, one.reference) : study.results.front();
        result.timeRatio = std::max(result.milliseconds, leastTime) / std::max(unit.milliseconds, leastTime);
    }
}

/// Compares the pictures of both routes. Their settings are equal but for the last check, and rays do not end early.
void checkSameRays(const RenderCase& one, RayCaster& caster, RenderStudy& study) {
    const auto check = [&](const std::string& name, double offsetPixels, auto change) {
        RayCastSettings settings = one.reference;
        settings.terminationTransmittance = 0.0;
        change(settings);
        const Picture plain = *castRaysPlainly(*one.volume, one.curve, settings, asTheKernel(settings.step));
        const double pixelMm = settings.camera.heightMm / settings.height;
        settings.camera.focalPoint += settings.camera.frame.right * (offsetPixels * pixelMm);
        study.sameRays.push_back({name, pictureError(*caster.cast(one.curve, settings), plain)});
    };
    check("equal settings", 0.0, [](RayCastSettings&) {});
    check("at half the size", 0.0, [](RayCastSettings& settings) { settings = reduced(settings, 2.0); });
    check("nearest voxel", 0.0, [](RayCastSettings& settings) { settings.interpolation = Interpolation::nearest; });
    check("the kernel's rays half a pixel off on purpose", 0.5, [](RayCastSettings&) {});
}

}  // namespace

Picture pictureOf(const RenderVariant& variant, const RenderCase& one, RayCaster& caster) {
    return enlarged(castOnce(variant, one, caster, 0.0), one.reference.width, one.reference.height);
}

RenderStudy measureRendering(const RenderCase& one, int repeats) {
    RenderStudy study;
    study.width = one.reference.width;
    study.height = one.reference.height;
    study.repeats = repeats;
    study.plainRepeats = std::min(repeats, mostPlainRepeats);
    study.threads = tbb::this_task_arena::max_concurrency();
    study.shaded = one.reference.shading.has_value();
    study.referenceSeconds = 1e-3 * millisecondsOf([&] { study.converged = convergedPicture(one); });
    RayCaster caster(one.volume);
    measureErrors(one, caster, study);
    checkSameRays(one, caster, study);
    measureTimes(one, caster, study);
    markFront(study.results);
    return study;
}

void markFront(std::vector<RenderResult>& results) {
    for (RenderResult& result : results) {
        const auto beats = [&](const RenderResult& other) {
            return !other.variant.plain &&
                   isBeaten(result.milliseconds, result.error.rmse, other.milliseconds, other.error.rmse);
        };
        result.onFront = !result.variant.plain && std::none_of(results.begin(), results.end(), beats);
    }
}

std::vector<QualityBound> qualityBounds() {
    return {{"converged", 0.5, 4.0}, {"high quality", 1.0, 8.0}, {"preview", 2.0}, {"preview", 4.0}, {"preview", 8.0}};
}

const RenderResult* fastestWithin(const QualityBound& bound, const std::vector<RenderResult>& results) {
    const RenderResult* fastest = nullptr;
    for (const RenderResult& result : results) {
        if (result.variant.plain || result.error.rmse > bound.rmse || result.error.largest > bound.largest) continue;
        if (fastest == nullptr || result.milliseconds < fastest->milliseconds) fastest = &result;
    }
    return fastest;
}

}  // namespace echolucent::cli
