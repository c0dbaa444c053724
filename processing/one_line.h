// Words from a file as one line that can be shown anywhere: what they hold beside letters does nothing there.
#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <string_view>

namespace echolucent {

/// The text in UTF-8, as one line. Control characters (below U+0020, U+007F to U+009F), the ends of lines and
/// paragraphs (U+2028, U+2029) and the characters that turn the direction of writing (U+202A to U+202E, U+2066 to
/// U+2069) become blanks, and bytes that are no UTF-8 become U+FFFD, so that no terminal and no label does what a text
/// asks. Where it is longer than `longest` bytes, it ends after a whole letter within them, and "..." stands behind it.
[[nodiscard]] std::string oneLine(std::string_view text, std::size_t longest = std::numeric_limits<std::size_t>::max());

}  // namespace echolucent
