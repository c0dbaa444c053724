// Writes volumes as MetaImage (.mha).
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "processing/result.h"
#include "processing/volume/volume.h"

namespace echolucent {

/// Writes one volume, or the phases of a 4D one (same size and type), as a compressed .mha, atomically (a temporary
/// file beside it, then renamed). The white level is kept in the key WhiteLevel, which readStudy() honours.
[[nodiscard]] Result<void> writeMetaImage(const std::string& path,
                                          const std::vector<std::shared_ptr<const Volume>>& phases);

}  // namespace echolucent
