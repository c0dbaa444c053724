// Text from a file as one line. It can be shown anywhere, because its control characters are gone.
#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <string_view>

namespace echolucent {

/// The text in UTF-8, as one line without characters that a terminal or a label would obey. Control characters (below
/// U+0020, U+007F to U+009F) become blanks. So do the ends of lines and paragraphs (U+2028, U+2029) and the characters
/// that turn the direction of writing (U+202A to U+202E, U+2066 to U+2069). Each byte that is no UTF-8 becomes U+FFFD.
/// If the line would be longer than `longest` bytes, it ends after the last whole letter within them, and "..."
/// follows, which is not counted.
[[nodiscard]] std::string oneLine(std::string_view text, std::size_t longest = std::numeric_limits<std::size_t>::max());

/// The number of letters of a text in UTF-8: its code points.
[[nodiscard]] std::size_t letterCount(std::string_view text);
/// The text in UTF-8 up to and with its first `most` letters.
[[nodiscard]] std::string_view firstLetters(std::string_view text, std::size_t most);

}  // namespace echolucent
