// A preview of a study that is being opened, from a few of its voxels.
#pragma once

#include <optional>

#include "processing/document/document.h"
#include "processing/picture/picture.h"
#include "processing/progress.h"
#include "processing/volume/coarse_grid.h"

namespace echolucent {

/// A preview of a pane's picture, much as it will be when the study is open. Beam, side and front are found on
/// the coarse grid (findOnOpening()); everything else is set as in `before`, the document that is open now. If the pane
/// has a designer, its curve stands in for the designer's OTF. Opacities are made to last over the grid's longer units.
/// The voxels are not quiet, whatever reduction the look names. `width` and `height` (pixels, each at least 1) give the
/// picture's shape. The picture is smaller than that if the grid cannot fill so many rays. The result is empty only if
/// progress.cancel was raised. Throws std::out_of_range if there is no such pane.
[[nodiscard]] std::optional<Picture> coarsePicture(const Document& before, std::size_t pane, const CoarseVolume& coarse,
                                                   int width, int height, const Progress& progress = {});

}  // namespace echolucent
