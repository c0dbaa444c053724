// Why an input cannot be opened or read and what to do, in words that a person can act on.
#pragma once

#include <string>

namespace echolucent {

/// What an error number of the system (errno) means for an input, lower case and without full stop: "it does not
/// exist", "the permission to read it, or to enter a folder above it, is missing".
[[nodiscard]] std::string inputProblem(int errorNumber);

/// What to do with a file that no honest program writes, as in Failure::remedy.
constexpr const char* doNotOpen = "The file is damaged or made to do harm: do not open it.";

}  // namespace echolucent
