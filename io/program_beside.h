// Where to find the programs that a program of Echolucent starts.
#pragma once

#include <string>

namespace echolucent {

/// The path of the program `name`: beside the running program if a file is there, else in the folder where it is
/// installed. The file may be missing.
[[nodiscard]] std::string programBeside(const std::string& name);

}  // namespace echolucent
