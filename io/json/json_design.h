// Configs of OTF designers as JSON.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "io/json/json_fields.h"
#include "processing/designers/choice/designer_config.h"

namespace echolucent {

/// "designer", its name, and "parameters", its table; of Kindlmann and Durkin's also "drawn", pairs of position and
/// opacity, and of a template's "reference": "name", "histogram", 256 shares, and "curve", by its "kind".
[[nodiscard]] nlohmann::ordered_json designJson(const DesignerConfig& config);
/// Parameters that are missing have their defaults, and so have "drawn" and "reference".
[[nodiscard]] DesignerConfig designIn(JsonFields& fields);

}  // namespace echolucent
