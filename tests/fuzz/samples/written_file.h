// The bytes that writers write into files.
#pragma once

#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>

#include "temporary_folder.h"

namespace echolucent {

/// The bytes that `write` puts into a file. `write` gets a path that ends in `name`, and returns whether it could
/// write.
template <typename Write>
[[nodiscard]] std::string bytesOfWritten(const std::string& name, const Write& write) {
    const TemporaryFolder folder;
    const std::string path = folder.file(name);
    if (!write(path)) throw std::runtime_error("a sample could not be written: " + name);
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace echolucent
