// Values that stand both in documents and in files of presets.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "io/json/json_fields.h"
#include "processing/document/curve_set.h"
#include "processing/document/method_choice.h"
#include "processing/picture/look.h"

namespace echolucent {

[[nodiscard]] nlohmann::ordered_json lookJson(const Look& look);
/// What is missing is that of lookAtStart().
[[nodiscard]] Look lookIn(JsonFields& fields);

/// The largest opacity scale and slope that a curve in a file may have, that of the method's opacity scale.
[[nodiscard]] double largestScale();

[[nodiscard]] nlohmann::ordered_json curvesJson(const CurveSet& curves);
[[nodiscard]] CurveSet curvesIn(JsonFields fields);

/// All but the direction. Where all tube cores are placed, no key says so.
[[nodiscard]] nlohmann::ordered_json methodJson(const MethodChoice& method);
/// The direction stays as by default.
[[nodiscard]] MethodChoice methodIn(JsonFields& fields);

}  // namespace echolucent
