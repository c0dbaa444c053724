// What the command line's JSON reports have in common.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "processing/volume/geometry.h"

namespace echolucent::cli {

/// Keys in the order they are written; doubles are written with as many digits as they need to come back the same.
using Json = nlohmann::ordered_json;

/// The number; null where it is not finite.
[[nodiscard]] Json finiteJson(double value);
/// The list of a vector's three numbers.
[[nodiscard]] Json vectorJson(const Vec3& vector);

}  // namespace echolucent::cli
