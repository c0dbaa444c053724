// How panes are compared. Their measures are in processing/comparison.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace echolucent {

/// How the compared panes share the room.
enum class ComparisonLayout {
    sideBySide,  ///< a pane each
    difference,  ///< one picture of the difference of two panes
    wipe,        ///< one of two panes left of a line, the other one right of it
};
/// "side_by_side", "difference", "wipe".
[[nodiscard]] std::string_view nameOf(ComparisonLayout layout);
[[nodiscard]] std::optional<ComparisonLayout> comparisonLayoutFromName(std::string_view name);

/// The most panes of a document, and the fewest that are compared.
inline constexpr std::size_t mostPanes = 4, fewestPanes = 2;
inline constexpr double leastAmplification = 1.0, largestAmplification = 32.0;

/// How two panes or more are compared.
struct Comparison {
    ComparisonLayout layout = ComparisonLayout::sideBySide;
    int first = 0, second = 1;   ///< the two panes of a difference or a wipe, as places among the panes; they differ
    double wipe = 0.5;           ///< [0, 1]: place of the wipe's line, as a share of the width
    double amplification = 4.0;  ///< [1, 32]: of differences in their picture
    bool colours = false;  ///< whether panes are coloured by their shown depths (ShownSurface), but in a difference
    friend bool operator==(const Comparison&, const Comparison&) = default;
};

/// What is out of range in a document of `panes` panes: "wipe must be from 0 to 1". Empty if nothing is. One pane
/// counts as fewestPanes.
[[nodiscard]] std::string problemOf(const Comparison& comparison, std::size_t panes);

}  // namespace echolucent
