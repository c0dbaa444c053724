// Documents whose study is counted from the other end of a grid axis: everything in them stays on the anatomy.
#pragma once

#include <optional>

#include "processing/document/document.h"
#include "processing/volume/grid_axis.h"
#include "processing/volume/volume.h"

namespace echolucent {

/// The document after the grid was turned round along an axis: every position shows the voxel that it showed, and
/// every direction, and what is up, runs the same way through the body. What was seen as a mirror image is seen as it
/// is: right and left of pictures change places, and with them the sides of the box, columns of tube cores, and which
/// way a motion has turned the view. `geometry` is of the grid before or after it was turned; both have one size. A
/// second turn undoes the first.
[[nodiscard]] Document turnedRound(Document document, GridAxis axis, const VolumeGeometry& geometry);

/// The document for its study as it was read: `turned` is Study::turnedAxis, `geometry` the grid of the study. If the
/// study's grid was turned round, and the document was made on the file's own grid (StudyFile::turnedAxis), it is
/// turned too. If the study's grid is the file's own, the document stays as it is. Its mark is then the study's.
[[nodiscard]] Document inGridOfStudy(Document document, std::optional<GridAxis> turned, const VolumeGeometry& geometry);

}  // namespace echolucent
