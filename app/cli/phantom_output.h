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

/// Fails (wrongUsage) if the name has an ending that is none of phantomEndings(). A name without an ending passes.
[[nodiscard]] Result<void> checkPhantomName(const std::string& path);

/// Writes the phases of a simulated scan in the format of the ending of `path`. The scan's beam is +z. A name without
/// an ending gets a MetaImage, and so does "-", the standard output. Fails as checkPhantomName() does, and (unwritable)
/// if the file cannot be written.
[[nodiscard]] Result<void> writePhantom(const std::string& path,
                                        const std::vector<std::shared_ptr<const Volume>>& phases);

}  // namespace echolucent::cli
