#include "processing/document/comparison.h"

#include <algorithm>

#include "processing/choice_names.h"

namespace echolucent {

namespace {
constexpr ChoiceNames<3> layoutNames{"side_by_side", "difference", "wipe"};
}

std::string_view nameOf(ComparisonLayout layout) { return nameIn(layoutNames, layout); }

std::optional<ComparisonLayout> comparisonLayoutFromName(std::string_view name) {
    return choiceNamed<ComparisonLayout>(layoutNames, name);
}

std::string problemOf(const Comparison& comparison, std::size_t panes) {
    const auto places = static_cast<int>(std::max(panes, fewestPanes));
    if (comparison.first < 0 || comparison.first >= places) return "first must be one of the panes";
    if (comparison.second < 0 || comparison.second >= places) return "second must be one of the panes";
    if (comparison.first == comparison.second) return "first and second must differ";
    if (!(comparison.wipe >= 0.0 && comparison.wipe <= 1.0)) return "wipe must be from 0 to 1";
    if (!(comparison.amplification >= leastAmplification && comparison.amplification <= largestAmplification))
        return "amplification must be from 1 to 32";
    return {};
}

}  // namespace echolucent
