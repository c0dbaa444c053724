// The two ways of telling tissue from fluid along a tube core. A method uses one.
#pragma once

#include <variant>

#include "processing/tube_core/rules/ratio_rule.h"
#include "processing/tube_core/rules/variance_rule.h"

namespace echolucent {

using DetectionRule = std::variant<VarianceRule, RatioRule>;

}  // namespace echolucent
