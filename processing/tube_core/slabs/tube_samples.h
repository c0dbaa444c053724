// The samples of a tube core, gathered slab by slab. A slab is one unit of the tube's length, cellSize x cellSize
// samples.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "processing/tube_core/rules/cell_rule.h"
#include "processing/tube_core/slabs/tube_grid.h"
#include "processing/volume/volume.h"

namespace echolucent {

/// Where the samples of a tube core lie, voxel index space. Sample (a, b) of slab k, 0 <= a, b < cellSize, lies at
/// first + k * along + (a - (cellSize - 1) / 2) * right + (b - (cellSize - 1) / 2) * down.
struct TubeSamples {
    Vec3 first{0, 0, 0};                                 ///< on the axis
    Vec3 along{0, 0, 1}, right{1, 0, 0}, down{0, 1, 0};  ///< one unit along the view's axes, in voxels
    int slabs = 0;
    int cellSize = 5;
    bool onVoxels =
        false;  ///< set by samplesOf(): all coordinates of samples are whole numbers, so nothing is interpolated

    [[nodiscard]] Vec3 onAxis(double slab) const { return first + along * slab; }
};

/// The samples along the axes of a view's tube cores; no slab if an axis misses the picture. Slabs are one unit apart.
/// The first lies half a unit behind the entry or, if tubesLieOnVoxels(), at the first voxel centre from the entry on.
[[nodiscard]] std::vector<TubeSamples> samplesOf(std::span<const TubeAxis> axes, const VolumeGeometry& geometry,
                                                 const Viewpoint& view, int cellSize);

/// Mean and sum of squared deviations over the samples of a slab with data, in normalised intensity.
struct SlabMoments {
    std::uint32_t count = 0;
    double mean = 0.0;
    double squaredDeviations = 0.0;
};

/// Moments of any tube in double precision, one sample after the other: the reference for tube_slabs.h. Samples are
/// interpolated trilinearly (exact if the position is whole) or are the nearest voxel. A sample outside the volume's
/// box is left out. If a voxel with a share in a sample carries no data, the sample is the nearest voxel. If the
/// nearest voxel carries no data, the sample is left out. `values` is scratch memory for reuse between calls.
void sampleSlabs(const Volume& volume, Interpolation sampling, const TubeSamples& tube, std::vector<SlabMoments>& slabs,
                 std::vector<double>& values);

}  // namespace echolucent
