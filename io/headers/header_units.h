// Units of length and time, by the names that headers give them.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace echolucent {

/// Whether a header's word for a unit says nothing: "", "none", "?", "???".
[[nodiscard]] bool saysNoUnit(std::string_view unit);
/// How many mm one unit of this name is, from nm to m and inches, short or in full, in any case; no value for an
/// unknown name.
[[nodiscard]] std::optional<double> mmOfUnit(std::string_view unit);
/// How many seconds one unit of this name is, from ns to hours; no value for an unknown name.
[[nodiscard]] std::optional<double> secondsOfUnit(std::string_view unit);

/// The units of length of several axes.
struct LengthUnits {
    std::vector<double> mm;  ///< length of each axis's unit; 1 if it is not known
    bool stated = false;     ///< whether the header names any
    bool known = true;       ///< false if a name is not understood, or if names are missing beside others than mm
    std::string warning;     ///< a sentence if the lengths are not known, or if one name stands for all; else empty

    /// Whether all axes have one unit.
    [[nodiscard]] bool areOne() const;
};
/// The units that the header's field `key` states for axes, one word for each; missing words are empty. Axes without a
/// word are in mm if all the others are. A single word counts for all axes.
[[nodiscard]] LengthUnits lengthUnits(const std::string& key, std::vector<std::string> words);

}  // namespace echolucent
