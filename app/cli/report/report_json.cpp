#include "app/cli/report/report_json.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace echolucent::cli {

Json finiteJson(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json vectorJson(const Vec3& vector) { return Json::array({vector[0], vector[1], vector[2]}); }

Json frontForwardJson(const Viewpoint& view) { return view.frontPlane ? vectorJson(view.frontPlane->forward) : Json(); }

}  // namespace echolucent::cli
