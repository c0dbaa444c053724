// How present data is beside the voxels of a volume, row by row (FilledVolume::presence).
#pragma once

#include <cstdint>
#include <functional>

#include "processing/volume/row_marks.h"
#include "processing/volume/volume.h"

namespace echolucent {

/// The presence of data is bytes of a white level of 255: the data mask, smoothed by the binomial [1 4 6 4 1] / 16
/// along each axis. So the surface at one half has no stairs. Where a voxel would end on the other side although it is
/// of a structure or a gap only a voxel wide, it keeps what the mask says. A voxel that is not finite is no data.
inline constexpr std::int64_t presenceReach = 2;  ///< voxels along each axis from which a mark is seen

/// Whether any voxel carries no data.
[[nodiscard]] bool lacksData(const Volume& volume);

/// Takes a slice's presence: its z and its first byte, rows of voxels one after another. Only the parts of rows that
/// were asked for hold something.
using TakePresence = std::function<void(std::int64_t z, const std::uint8_t* slice)>;
/// Makes the presence of parts of rows. Slices without any are left out; the others are taken once each, side by side,
/// in no order.
void makePresence(const Volume& volume, const RowMarks& rows, const TakePresence& take);

}  // namespace echolucent
