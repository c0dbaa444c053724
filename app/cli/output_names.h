// What the ending of an output's name says of its format.
#pragma once

#include <string>

#include "processing/result.h"

namespace echolucent::cli {

/// Fails (wrong usage) where `path` ends as movies or as other pictures than PNG do; `option` is what the command line
/// calls the output. Names without a known ending pass, and so do devices and "-".
[[nodiscard]] Result<void> checkPictureName(const std::string& path, const std::string& option);
/// Fails (wrong usage) where the ending of a movie's name is none of movieContainers; an empty path and "-" pass.
[[nodiscard]] Result<void> checkMovieName(const std::string& path, const std::string& option);
/// The same for volumes that are written as MetaImage (.mha, .mhd): endings of other volumes are refused too.
[[nodiscard]] Result<void> checkMetaImageName(const std::string& path, const std::string& option);

}  // namespace echolucent::cli
