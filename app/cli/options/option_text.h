// What the text of an option says, for every command: numbers, and what is wrong with them in the same words.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "processing/result.h"

namespace echolucent::cli {

/// A failure of wrong usage. `option` is the option as a person writes it, `problem` what it is or must be ("must be 0
/// or more"), `remedy` a sentence that says what to write instead, or nothing.
[[nodiscard]] tl::unexpected<Failure> wrongUsage(const std::string& option, const std::string& problem,
                                                 const std::string& remedy = {});

/// "AxB" or "AxBxC" (also with commas) into numbers; fails with `option` named, and with `example` as what it must be
/// like.
[[nodiscard]] Result<std::vector<double>> parseNumbers(const std::string& text, std::size_t count,
                                                       const std::string& option, const std::string& example);

/// "AxB" into two whole numbers from `least` to `largest`; fails with `option` named and with `example` as remedy.
[[nodiscard]] Result<std::array<int, 2>> parseWholePair(const std::string& text, int least, int largest,
                                                        const std::string& option, const std::string& example);

/// Whether an angle in degrees is finite and near enough to 0 for a double to tell it from the next, +-36000.
[[nodiscard]] bool isAngle(double degrees);
/// What an option says that isAngle() refuses, as the problem of wrongUsage().
inline constexpr const char* mustBeAngles = "must be angles in degrees, -36000 to 36000";

/// "a, b or c".
[[nodiscard]] std::string listed(const std::vector<std::string_view>& names);

/// Says a note on stderr; an empty one is none.
void sayNote(const std::string& note);

}  // namespace echolucent::cli
