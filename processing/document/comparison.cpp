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

std::string problemOf(const Comparison& comparison) {
    const std::vector<int>& panes = comparison.panes;
    if (!panes.empty() && (panes.size() < fewestPanes || panes.size() > mostPanes))
        return "panes must hold 2 to 4 views, or none";
    if (std::ranges::any_of(panes, [&](int view) { return std::ranges::count(panes, view) > 1; }))
        return "panes must hold each view once";
    const auto places = static_cast<int>(panes.empty() ? fewestPanes : panes.size());
    if (comparison.first < 0 || comparison.first >= places) return "first must be one of the panes";
    if (comparison.second < 0 || comparison.second >= places) return "second must be one of the panes";
    if (comparison.first == comparison.second) return "first and second must differ";
    if (!(comparison.wipe >= 0.0 && comparison.wipe <= 1.0)) return "wipe must be from 0 to 1";
    if (!(comparison.amplification >= leastAmplification && comparison.amplification <= largestAmplification))
        return "amplification must be from 1 to 32";
    return {};
}

}  // namespace echolucent
