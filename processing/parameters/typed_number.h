// Numbers as a person types them: one rule for the window and the command line, whatever the language of the desktop.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "processing/parameters/parameter.h"

namespace echolucent {

/// What a typed text reads as.
struct TypedNumber {
    double value = 0.0;
    std::optional<double> otherwise{};  ///< what else it may mean: "1,234" is 1.234, or 1234
    bool hasMark = false;               ///< whether there is a decimal mark, where value is meant
};

/// Reads a decimal number that a person typed; no value for any other text, and for groups that are not of three
/// digits. White space around it does not count.
///
/// A point is the decimal mark, as numbers are shown. So is a comma. If both stand there, the last one is, and the
/// others separate thousands ("1.234,5" and "1,234.5" are 1234.5). A mark that stands there more than once separates
/// thousands ("1,234,567"), as do blanks and apostrophes. A single comma behind one to three digits and before exactly
/// three may be either; TypedNumber::otherwise then is the number of thousands.
[[nodiscard]] std::optional<TypedNumber> typedNumber(std::string_view text);

/// Whole numbers below 2^53. A double cannot tell 2^53 from 2^53 + 1.
inline constexpr ParameterRange exactWholeNumbers{-9007199254740991.0, 9007199254740991.0};

/// The only reading of a typed text that lies in the range and, if `whole`, has no decimal mark. No value if there is
/// none or if two of them do, so that nobody's number becomes a thousand times larger or smaller unseen.
[[nodiscard]] std::optional<double> numberTyped(std::string_view text, const ParameterRange& range, bool whole = false);

/// Whether a typed text has two readings that numberTyped() would take.
[[nodiscard]] bool isDoubtful(std::string_view text, const ParameterRange& range, bool whole = false);

/// The remedy for a doubtful text, a full sentence: it says both readings.
[[nodiscard]] std::string remedyOfDoubt(std::string_view text);

}  // namespace echolucent
