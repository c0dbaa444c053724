// Says why an input cannot be opened or read and what to do, in words that a person can act on.
#pragma once

#include <string>

namespace echolucent {

/// An error number of the system (errno) in words about an input, lower case, no full stop: "it does not exist", "the
/// permission to read it, or to enter a folder above it, is missing".
[[nodiscard]] std::string inputProblem(int errorNumber);

/// Whether an error number says that a disc, or the way to it, has failed: it was pulled out, or its server is gone.
[[nodiscard]] bool isDiscFailure(int errorNumber);

/// As Failure::remedy, for a file that no honest program writes.
constexpr const char* doNotOpen = "The file is damaged or made to do harm: do not open it.";

// As Failure::remedy, for a file that cannot be read.
constexpr const char* copyAgain = "Copy or export it again.";
constexpr const char* incompleteFile = "The file is incomplete: copy or export it again.";
constexpr const char* damagedFile = "The file is incomplete or damaged: copy or export it again.";
constexpr const char* exportAgain = "Export the volume again.";
constexpr const char* correctHeader = "Correct the header or export the volume again.";

}  // namespace echolucent
