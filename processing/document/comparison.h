// Which views are compared side by side, and how; what is measured of them is in processing/comparison.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace echolucent {

/// How what is compared shares the room.
enum class ComparisonLayout {
    sideBySide,  ///< a pane each
    difference,  ///< one picture of the difference of two
    wipe,        ///< one of two left of a line, the other one right of it
};
/// "side_by_side", "difference", "wipe".
[[nodiscard]] std::string_view nameOf(ComparisonLayout layout);
[[nodiscard]] std::optional<ComparisonLayout> comparisonLayoutFromName(std::string_view name);

inline constexpr std::size_t fewestPanes = 2, mostPanes = 4;
inline constexpr double leastAmplification = 1.0, largestAmplification = 32.0;

/// The default compares nothing.
struct Comparison {
    std::vector<int> panes{};  ///< ids of views, each once; empty, or fewestPanes to mostPanes
    ComparisonLayout layout = ComparisonLayout::sideBySide;
    int first = 0, second = 1;   ///< places in `panes` of the two of a difference or a wipe; they differ
    double wipe = 0.5;           ///< [0, 1]: where the line of the wipe stands, as a share of the width
    double amplification = 4.0;  ///< [1, 32]: of differences in a picture of them
    friend bool operator==(const Comparison&, const Comparison&) = default;
};

/// What is out of range, as "panes must hold 2 to 4 views"; an empty text where nothing is.
[[nodiscard]] std::string problemOf(const Comparison& comparison);

}  // namespace echolucent
