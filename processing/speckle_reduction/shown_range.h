// The stored values that a filter of speckle reduction may read, and those it may write.
#pragma once

#include "processing/volume/volume.h"

namespace echolucent {

/// The volume with its data clamped to the range of a picture, 0 to the white level. Otherwise single absurd voxels of
/// float files would shine through all their surroundings. Voxels without data stay. If nothing changes, the result
/// shares the volume's voxels.
[[nodiscard]] Volume withinWhite(const Volume& volume);

/// The least and the largest stored value of the voxels with data. Both are 0 if no voxel has data. Bytes with a white
/// level of at least 255 always get 0 and 255. A filter clamps its means between the two, so that data of one value
/// keep that value in spite of rounding and withinWhite().
struct StoredBounds {
    double lowest = 0.0, highest = 0.0;
};
[[nodiscard]] StoredBounds storedBounds(const Volume& volume);

}  // namespace echolucent
