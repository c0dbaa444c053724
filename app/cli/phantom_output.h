// Where the phantom command writes what it made: the format follows the name's ending.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "processing/result.h"
#include "processing/volume/volume.h"

namespace echolucent::cli {

/// The endings that writePhantom() knows, for help and messages: ".mha, .mhd, .nii, .nii.gz or .dcm".
[[nodiscard]] std::string phantomEndings();

/// Whether a phantom can be written to a file of this name. Fails (wrongUsage) where no format has its ending.
[[nodiscard]] Result<void> checkPhantomName(const std::string& path);

/// Writes the phases of a simulated scan, whose beam is +z, in the format that the ending of `path` asks for; "-" is a
/// MetaImage on the standard output. Fails (wrongUsage, unwritable) where no format has that ending or where the file
/// cannot be written.
[[nodiscard]] Result<void> writePhantom(const std::string& path,
                                        const std::vector<std::shared_ptr<const Volume>>& phases);

}  // namespace echolucent::cli
