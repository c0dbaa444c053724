// Writes volumes as MetaImage (.mha).
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "processing/result.h"
#include "processing/volume/volume.h"

namespace echolucent {

/// How voxels are written: compressed, or as they stand in memory, which other programs can map.
enum class MetaImageVoxels { compressed, plain };

/// Writes one volume, or the phases of a 4D one, to `path` as an .mha, whole or not at all. The white level
/// is kept in the key WhiteLevel, which readStudy() honours. Throws std::invalid_argument where there is no phase or
/// where the phases differ in size or type; fails (unwritable) where the file cannot be written.
[[nodiscard]] Result<void> writeMetaImage(const std::string& path,
                                          const std::vector<std::shared_ptr<const Volume>>& phases,
                                          MetaImageVoxels voxels = MetaImageVoxels::compressed);

}  // namespace echolucent
