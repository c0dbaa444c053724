// What a study that is being opened will look like, from a few of its voxels.
#pragma once

#include <optional>

#include "processing/document/document.h"
#include "processing/picture/picture.h"
#include "processing/progress.h"
#include "processing/volume/coarse_grid.h"

namespace echolucent {

/// The picture of a view, as it will be when the study is open: beam and cut are found on the coarse grid
/// (findOnOpening()), all else that is set is that of `before`, the document of what is open now. Opacities are made to
/// last over the grid's longer units. Voxels are shown as they are, whatever reduction the look names. `width` and
/// `height` (pixels, each at least 1) give the picture's shape; it has no more rays than the grid has something to
/// show. The result is empty only where progress.cancel was raised.
[[nodiscard]] std::optional<Picture> coarsePicture(const Document& before, std::size_t pane, const CoarseVolume& coarse,
                                                   int width, int height, const Progress& progress = {});

}  // namespace echolucent
