// What the command line's JSON reports share.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "processing/viewpoint/viewpoint.h"
#include "processing/volume/geometry.h"

namespace echolucent::cli {

/// Keys keep the order in which they are written. Doubles have as many digits as reading them back needs.
using Json = nlohmann::ordered_json;

/// The number; null if it is not finite.
[[nodiscard]] Json finiteJson(double value);
[[nodiscard]] Json vectorJson(const Vec3& vector);
/// FrontPlane::forward of the view's flat front; null if it has none.
[[nodiscard]] Json frontForwardJson(const Viewpoint& view);

}  // namespace echolucent::cli
