// How panes are compared; what is measured of them is in processing/comparison.
#pragma once

#include <optional>
#include <string>
#include <string_view>

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

/// So many panes a document may have, and so many are compared.
inline constexpr std::size_t mostPanes = 4, fewestPanes = 2;
inline constexpr double leastAmplification = 1.0, largestAmplification = 32.0;

/// Of a document of two panes or more.
struct Comparison {
    ComparisonLayout layout = ComparisonLayout::sideBySide;
    int first = 0, second = 1;   ///< places among the panes of the two of a difference or a wipe; they differ
    double wipe = 0.5;           ///< [0, 1]: where the line of the wipe stands, as a share of the width
    double amplification = 4.0;  ///< [1, 32]: of differences in a picture of them
    friend bool operator==(const Comparison&, const Comparison&) = default;
};

/// What is out of range in a document of so many panes, as "wipe must be from 0 to 1"; an empty text where nothing is.
[[nodiscard]] std::string problemOf(const Comparison& comparison, std::size_t panes);

}  // namespace echolucent
