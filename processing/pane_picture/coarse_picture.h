// A preview of a study that is being opened, from a few of its voxels.
#pragma once

#include <optional>

#include "processing/document/document.h"
#include "processing/picture/picture.h"
#include "processing/progress.h"
#include "processing/volume/coarse_grid.h"

namespace echolucent {

/// The picture of a pane, as it will be when the study is open. Beam and front are found on the coarse grid
/// (findOnOpening()); everything else is set as in `before`, the document that is open now. Opacities are made to last
/// over the grid's longer units. The voxels are not quiet, whatever reduction the look names. `width` and `height`
/// (pixels, each at least 1) give the picture's shape; it has no more rays than the grid can fill. The result is empty
/// only if progress.cancel was raised.
[[nodiscard]] std::optional<Picture> coarsePicture(const Document& before, std::size_t pane, const CoarseVolume& coarse,
                                                   int width, int height, const Progress& progress = {});

}  // namespace echolucent
