// Computes the presence of data around a volume's voxels, row by row (FilledVolume::presence).
#pragma once

#include <cstdint>
#include <functional>

#include "processing/volume/row_marks.h"
#include "processing/volume/volume.h"

namespace echolucent {

// The presence of data is one byte a voxel, 255 for full presence. It is the data mask, smoothed by the binomial
// [1 4 6 4 1] / 16 along each axis, so that the surface at which it is one half has no stairs. A structure or a gap
// that is only one voxel wide would vanish: its voxels keep what the mask says. A voxel that is not finite is no data.

inline constexpr std::int64_t presenceReach = 2;  ///< how many voxels along each axis a mark reaches

/// Whether any voxel carries no data.
[[nodiscard]] bool lacksData(const Volume& volume);

/// Takes a slice's presence: z and the first byte, rows one after another. Only the requested parts of rows are filled.
using TakePresence = std::function<void(std::int64_t z, const std::uint8_t* slice)>;
/// Makes the presence of parts of rows and hands over each slice once, in no order and on several threads. Slices
/// without such parts are left out.
void makePresence(const Volume& volume, const RowMarks& rows, const TakePresence& take);

}  // namespace echolucent
