// Computes the presence of data around a volume's voxels, row by row (FilledVolume::presence).
#pragma once

#include <cstdint>
#include <functional>

#include "processing/volume/row_marks.h"
#include "processing/volume/volume.h"

namespace echolucent {

// The presence of data is one byte a voxel, 255 for full presence. It is the data mask, smoothed along each axis by the
// binomial [1 4 6 4 1] / 16. Stairs of an oblique border are longer than that. So a kernel of 13 voxels tells where the
// border is, and how far a voxel lies from it, and thus which presence the binomial would have there without stairs.
// Where the two disagree by more than stairs explain (at corners, and at structures and gaps a few voxels thick), the
// binomial alone counts. It would remove what is only one voxel wide, so the voxels there keep what the mask says. A
// voxel that is not finite is no data.

inline constexpr std::int64_t presenceReach = 6;  ///< how far a voxel's mark reaches along each axis, voxels

/// Whether any voxel carries no data.
[[nodiscard]] bool lacksData(const Volume& volume);

/// Takes the presence in slice `z`: its first byte, rows one after another. Only the parts of rows that were asked for
/// are filled. The bytes are valid during the call.
using TakePresence = std::function<void(std::int64_t z, const std::uint8_t* slice)>;
/// Makes the presence of the marked parts of `rows`. Calls `take` once for each slice that has such parts, in no order
/// and on several threads.
void makePresence(const Volume& volume, const RowMarks& rows, const TakePresence& take);

}  // namespace echolucent
