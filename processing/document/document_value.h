// One value of a document, as conditions compare it.
#pragma once

#include <string>
#include <variant>

namespace echolucent {

/// Nothing, yes or no, a number (without unit), or a text.
using DocumentValue = std::variant<std::monostate, bool, double, std::string>;

}  // namespace echolucent
