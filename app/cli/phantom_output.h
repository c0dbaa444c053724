// Writes the phantom command's result. The format follows the name's ending.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "processing/result.h"
#include "processing/volume/volume.h"

namespace echolucent::cli {

/// The endings that writePhantom() knows, for help and messages: ".mha, .mhd, .nii, .nii.gz or .dcm".
[[nodiscard]] std::string phantomEndings();

/// Fails (wrongUsage) if no format has the name's ending.
[[nodiscard]] Result<void> checkPhantomName(const std::string& path);

/// Writes the phases of a simulated scan, whose beam is +z, in the format of the ending of `path`. "-" is a MetaImage
/// on the standard output. Fails (wrongUsage) if no format has that ending, and (unwritable) if the file cannot be
/// written.
[[nodiscard]] Result<void> writePhantom(const std::string& path,
                                        const std::vector<std::shared_ptr<const Volume>>& phases);

}  // namespace echolucent::cli
