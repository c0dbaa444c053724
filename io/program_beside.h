// Where the programs lie that a program of Echolucent starts.
#pragma once

#include <string>

namespace echolucent {

/// The path of the program `name`: beside the running one, else where it is installed. Nothing says that it is there.
[[nodiscard]] std::string programBeside(const std::string& name);

}  // namespace echolucent
