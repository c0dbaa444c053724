// Which stored values a filter of speckle reduction takes in, and which it may give out.
#pragma once

#include "processing/volume/volume.h"

namespace echolucent {

/// The volume with its data within what a picture can show: what is above the white level is white, what is below 0 is
/// 0. Single absurd voxels, as float files hold them, would shine through all of their surroundings. Voxels without
/// data stay. Where nothing changes the result shares the volume's voxels.
[[nodiscard]] Volume withinWhite(const Volume& volume);

/// The least and the largest stored value among the voxels with data; both are 0 where no voxel has data. Of bytes
/// whose white level is not below 255 they are 0 and 255, whatever is stored. Means are kept between them, so that
/// neither rounding nor withinWhite() moves a constant.
struct StoredBounds {
    double lowest = 0.0, highest = 0.0;
};
[[nodiscard]] StoredBounds storedBounds(const Volume& volume);

}  // namespace echolucent
