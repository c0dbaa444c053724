// How the program was called.
#pragma once

#include <string>
#include <vector>

namespace echolucent::cli {

/// How the program was called.
struct Invocation {
    std::string program;                 ///< name and version
    std::vector<std::string> arguments;  ///< as they were given
};

}  // namespace echolucent::cli
