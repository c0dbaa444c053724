// Reads the text of options for every command, and words their errors alike.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "processing/parameters/parameter.h"
#include "processing/result.h"

namespace echolucent::cli {

/// A failure of wrong usage. `option` is the option as a person writes it. `problem` says what it is or must be ("must
/// be 0 or more"). `remedy` is a sentence that says what to write instead, or empty.
[[nodiscard]] tl::unexpected<Failure> wrongUsage(const std::string& option, const std::string& problem,
                                                 const std::string& remedy = {});

/// Reads `count` numbers with "x" or commas between them: "A", "AxB", "AxBxC". A failure (wrong usage) names `option`,
/// and says that it must be like `example`.
[[nodiscard]] Result<std::vector<double>> parseNumbers(const std::string& text, std::size_t count,
                                                       const std::string& option, const std::string& example);

/// Reads "AxB" as two whole numbers from `least` to `largest`. A failure names `option`, with `example` as remedy.
[[nodiscard]] Result<std::array<int, 2>> parseWholePair(const std::string& text, int least, int largest,
                                                        const std::string& option, const std::string& example);

/// Whether an angle in degrees is finite and within +-36000. There a double still tells neighbouring angles apart.
[[nodiscard]] bool isAngle(double degrees);
/// The problem of wrongUsage() if isAngle() refuses an option's angle.
inline constexpr const char* mustBeAngles = "must be angles in degrees, -36000 to 36000";

/// "a, b or c".
[[nodiscard]] std::string listed(const std::vector<std::string_view>& names);

/// Prints a note on stderr, unless it is empty.
void sayNote(const std::string& note);

/// A value as people write it on the command line.
[[nodiscard]] std::string wordOf(const ParameterValue& value);

}  // namespace echolucent::cli
