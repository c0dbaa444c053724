// Reads and writes configs of OTF designers as JSON.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "io/json/json_fields.h"
#include "processing/designers/choice/designer_config.h"

namespace echolucent {

/// An object with "designer", the name, and "parameters", the values of the designer's table. Kindlmann and Durkin's
/// designer also has "drawn", pairs of position and opacity. A template also has "reference": "name", "histogram" (256
/// shares), and "curve" (by its "kind").
[[nodiscard]] nlohmann::ordered_json designJson(const DesignerConfig& config);
/// Missing parameters get their defaults, and so do "drawn" and "reference".
[[nodiscard]] DesignerConfig designIn(JsonFields& fields);

}  // namespace echolucent
