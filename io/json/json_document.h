// Reads and writes values that both documents and preset files hold.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "io/json/json_fields.h"
#include "processing/document/curve_set.h"
#include "processing/document/method_choice.h"
#include "processing/picture/look.h"

namespace echolucent {

[[nodiscard]] nlohmann::ordered_json lookJson(const Look& look);
/// Missing parameters are those of lookAtStart().
[[nodiscard]] Look lookIn(JsonFields& fields);

/// The largest opacity scale and slope of a curve in a file: that of the method's opacity scale.
[[nodiscard]] double largestScale();

/// "lower", "slope", "upper".
[[nodiscard]] nlohmann::ordered_json linearCurveJson(const LinearCurve& curve);
[[nodiscard]] LinearCurve linearCurveIn(JsonFields fields);
[[nodiscard]] nlohmann::ordered_json curvesJson(const CurveSet& curves);
[[nodiscard]] CurveSet curvesIn(JsonFields fields);

/// The method without its direction. The key of the tube cores that are left out is missing if none is.
[[nodiscard]] nlohmann::ordered_json methodJson(const MethodChoice& method);
/// The parameters alone, without those of the initial function and the tube cores that are left out.
[[nodiscard]] nlohmann::ordered_json methodParametersJson(const AdaptiveOtfConfig& config);
/// Missing parameters are the defaults.
[[nodiscard]] AdaptiveOtfConfig methodParametersIn(JsonFields& fields);
/// Reads what methodJson() writes, and leaves the direction at its default.
[[nodiscard]] MethodChoice methodIn(JsonFields& fields);

}  // namespace echolucent
