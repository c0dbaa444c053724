// Writes volumes as MetaImage (.mha).
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "processing/result.h"
#include "processing/volume/volume.h"

namespace echolucent {

/// Writes one volume, or the phases of a 4D one, to `path` as a compressed .mha, whole or not at all. The white level
/// is kept in the key WhiteLevel, which readStudy() honours. Throws std::invalid_argument where there is no phase or
/// where the phases differ in size or type; fails (unwritable) where the file cannot be written.
[[nodiscard]] Result<void> writeMetaImage(const std::string& path,
                                          const std::vector<std::shared_ptr<const Volume>>& phases);

}  // namespace echolucent
