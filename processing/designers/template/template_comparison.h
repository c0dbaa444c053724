// How the intensities of a volume and of a template are compared.
#pragma once

#include <array>
#include <string_view>

#include "processing/choice_names.h"

namespace echolucent {

/// What is compared of two distributions.
enum class TemplateComparison {
    logarithm,   ///< logarithms of the shares of voxels, and with less weight the cumulative distributions
    cumulative,  ///< the cumulative distributions alone
};
inline constexpr std::array allTemplateComparisons{TemplateComparison::logarithm, TemplateComparison::cumulative};
inline constexpr ChoiceNames<allTemplateComparisons.size()> templateComparisonNames{"logarithm", "cumulative"};
/// "logarithm", "cumulative".
[[nodiscard]] inline std::string_view nameOf(TemplateComparison comparison) {
    return nameIn(templateComparisonNames, comparison);
}

}  // namespace echolucent
