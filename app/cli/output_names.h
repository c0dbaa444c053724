// Checks the endings of outputs' names.
#pragma once

#include <string>

#include "processing/result.h"

namespace echolucent::cli {

/// Fails (wrong usage) if `path` ends as movies or as pictures other than PNG do. `option` is the output's name on the
/// command line. Names without such an ending pass, and so do devices and "-".
[[nodiscard]] Result<void> checkPictureName(const std::string& path, const std::string& option);
/// Fails (wrong usage) if a movie's name ends in none of movieContainers. An empty path and "-" pass.
[[nodiscard]] Result<void> checkMovieName(const std::string& path, const std::string& option);
/// Fails (wrong usage) if `path` ends as pictures, movies or volumes other than MetaImage (.mha, .mhd) do. Names
/// without such an ending pass, and so do devices and "-".
[[nodiscard]] Result<void> checkMetaImageName(const std::string& path, const std::string& option);

}  // namespace echolucent::cli
