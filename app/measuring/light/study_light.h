// The parts of `study light`: the light volumes to compare with the reference, the measures, and the page.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/measuring/measures/picture_difference.h"
#include "app/measuring/measures/reference_light.h"
#include "app/pages/html_page.h"
#include "processing/light/light_sweep.h"
#include "processing/opacity_curve.h"
#include "processing/picture/ray_cast_settings.h"
#include "processing/volume/volume.h"

namespace echolucent::cli {

struct LightCase {
    std::string name;
    std::shared_ptr<const Volume> volume;
    OpacityCurve curve;
    RayCastSettings settings;
};

/// One way to make a light volume.
struct LightVariant {
    std::string parameter, value;
    LightScene scene;
};
/// First the default, then one parameter at a time: coarseness, directions of the key light, directions around.
[[nodiscard]] std::vector<LightVariant> lightVariants(const LightScene& usual);

/// The results of a variant.
struct LightResult {
    LightVariant variant;
    PictureError error;               ///< difference of the picture from the one with the reference's light
    double milliseconds = 0.0;        ///< median; a new camera and a new curve
    double turnedMilliseconds = 0.0;  ///< median; a new camera, with which the key light turns, and the same curve
    double keyMilliseconds = 0.0;     ///< median; a new key light alone
};

struct LightStudy {
    std::string name;
    double referenceSeconds = 0.0;
    Picture reference, usual;      ///< with the reference's light, and with the default light volume
    PictureError withoutReaching;  ///< difference of the picture with gradient light alone from `reference`
    std::vector<LightResult> results;
};
/// `rings` as in ReferenceLight.
[[nodiscard]] LightStudy measureLight(const LightCase& one, int repeats, int rings);

[[nodiscard]] std::string lightCsv(const std::vector<LightStudy>& studies);
[[nodiscard]] std::string lightPage(const std::vector<LightStudy>& studies, int repeats, int rings);
[[nodiscard]] std::string lightSummary(const std::vector<LightStudy>& studies);

}  // namespace echolucent::cli
