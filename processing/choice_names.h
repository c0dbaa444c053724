// Names of an enumeration's choices, for its nameOf() and ...FromName().
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

namespace echolucent {

/// The names of an enumeration's choices, in the order of their values. The values count up from 0.
template <std::size_t count>
using ChoiceNames = std::array<std::string_view, count>;

template <std::size_t count, typename Choice>
[[nodiscard]] constexpr std::string_view nameIn(const ChoiceNames<count>& names, Choice choice) {
    return names.at(static_cast<std::size_t>(choice));
}

/// The choice of that name. Empty if there is none.
template <typename Choice, std::size_t count>
[[nodiscard]] constexpr std::optional<Choice> choiceNamed(const ChoiceNames<count>& names, std::string_view name) {
    for (std::size_t i = 0; i < count; ++i)
        if (names[i] == name) return static_cast<Choice>(i);
    return std::nullopt;
}

}  // namespace echolucent
