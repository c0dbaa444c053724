// Which voxels of a volume hold no data where its file does not say it.
#pragma once

#include <memory_resource>

#include "processing/volume/volume.h"

namespace echolucent {

/// Guesses which voxels lie outside the scanned sector. They are exactly 0 and connected over faces through such voxels
/// to the border of the grid. Together they hold a corner of the grid, which a sector always leaves free, are at least
/// 2 % of the grid, and thick (the zeros of speckle are not). An echo is never guessed away: lone noisy voxels in the
/// midst of the outside stay data, as wires do that are thinner than they.
/// A pool of fluid that is 0 throughout and touches the border is taken for outside too, where corners are free.
/// Returns one byte a voxel (1 is data), joined with the volume's own mask; where there is no such region, the volume's
/// own mask. What is returned lies in `memory`, which outlives it.
[[nodiscard]] DataMask guessDataMask(const Volume& volume,
                                     std::pmr::memory_resource& memory = *std::pmr::new_delete_resource());

/// The volume's mask with the guess taken back: every voxel that holds exactly 0 is data again, because a guess takes
/// no other. What a scalpel cut stays cut. It is empty where all voxels are data then.
[[nodiscard]] DataMask dataMaskWithoutGuess(const Volume& volume);

}  // namespace echolucent
