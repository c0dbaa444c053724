// Writes volumes as MetaImage (.mha).
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "processing/result.h"
#include "processing/volume/volume.h"

namespace echolucent {

/// Voxels are compressed, or plain as in memory, so that other programs can map the file.
enum class MetaImageVoxels { compressed, plain };

/// Writes one volume, or the phases of a 4D one, to `path` as an .mha, whole or not at all. The keys WhiteLevel and, if
/// black is not 0, BlackLevel keep both for readStudy(). Voxels are the file's own values (typeOfFileValues()). All
/// phases get the geometry and the white level of the first one; the time between them is not kept. Throws
/// std::invalid_argument if there is no phase, or if phases differ in size, type or scale. Fails (unwritable) if the
/// file cannot be written.
[[nodiscard]] Result<void> writeMetaImage(const std::string& path,
                                          const std::vector<std::shared_ptr<const Volume>>& phases,
                                          MetaImageVoxels voxels = MetaImageVoxels::compressed);

}  // namespace echolucent
