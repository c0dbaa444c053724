// The rim in which the data of a scan fade towards no data.
#pragma once

#include <vector>

#include "processing/volume/bit_grid.h"
#include "processing/volume/volume.h"

namespace echolucent {

/// Where a scan was interpolated onto its grid, the outermost voxels of its data mix echo with what lies outside, where
/// nothing is. They are darker than the tissue there, and by how much changes from voxel to voxel, as the border passes
/// through the grid (docs/speckle.md). The rim is as many layers of such voxels as the volume has, counted over faces
/// from solid no data. No data is solid if it is more than a voxel thick: the rim goes round no single voxel that is
/// not finite. What is too thin to have more than a rim is no rim.
class FadedRim {
public:
    explicit FadedRim(const Volume& volume);

    /// How many layers fade. Layer n does not fade if its mean is at least 0.9 of the mean of layer n + 2. 0 if the
    /// volume has no border, or if it fades over more than mostLayers: then echo itself grows towards the inside.
    [[nodiscard]] int layers() const { return static_cast<int>(m_layers.size()); }
    /// The volume with the rim marked as no data; the same volume if there is no rim.
    [[nodiscard]] Volume without(const Volume& volume) const;
    /// `quiet`, a volume of the same grid, whose rim holds means of what lies inside it, layer by layer, as
    /// FilledVolume fills voxels without data. An inner layer of the rim holds at least half of its echo: there means
    /// are limited to twice the value that `quiet` has. So fluid at the border stays dark. The mask marks the rim as
    /// data again.
    [[nodiscard]] Volume filled(const Volume& quiet) const;

    static constexpr int mostLayers = 4;

private:
    DataMask m_mask;                ///< of the volume, with the rim
    std::vector<BitGrid> m_layers;  ///< of the rim, the outermost first
    BitGrid m_inner;                ///< the data within the rim
};

}  // namespace echolucent
