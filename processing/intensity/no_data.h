// Which voxels of a volume hold no data, if its file does not say so.
#pragma once

#include <memory_resource>

#include "processing/volume/volume.h"

namespace echolucent {

/// Guesses which voxels lie outside the scanned sector. They are empty, not finite or no data already, and connected
/// over faces through such voxels to the border of the grid. Empty voxels hold exactly 0. If black is not 0, they hold
/// black or less, or else, if no such region is found, exactly the file's 0. Together they hold a corner of the grid,
/// which a sector always leaves free. They are at least 2 % of the grid, and thick; the zeros of speckle are not. The
/// guess never takes an echo: lone noisy voxels outside the sector stay data. If all echoes are thinner than the
/// outside between them, as wires in water are, nothing is guessed. But the guess does take a pool of fluid that is
/// empty throughout and touches the border, if corners are free.
///
/// Returns one byte a voxel (1 is data), joined with the volume's own mask. Without such a region, returns the volume's
/// own mask. A new mask lies in `memory`, which must outlive it.
[[nodiscard]] DataMask guessDataMask(const Volume& volume,
                                     std::pmr::memory_resource& memory = *std::pmr::new_delete_resource());

/// The volume's mask without the guess: empty voxels are data again, also those that the file itself
/// masked. Voxels that are not finite stay no data, and what a scalpel cut stays cut. The mask is empty if all voxels
/// are data then.
[[nodiscard]] DataMask dataMaskWithoutGuess(const Volume& volume);

}  // namespace echolucent
