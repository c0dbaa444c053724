// Sums up the slabs of a row of tube cores, many at a time: in exact integers if samples are voxels, in single
// precision if they are interpolated. A lane of a vector is a slab, and its samples are added in a fixed order. So the
// bits are the same on any instruction set and any number of threads.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "processing/tube_core/slabs/tube_samples.h"

namespace echolucent {

/// Exact sums over the data voxels of a tube's slabs, in stored values. One entry for each slab.
struct SlabSums {
    std::vector<std::int32_t> counts;
    std::vector<std::int32_t> sums;  ///< at most 32^2 * 65535
    std::vector<std::uint64_t> sumsOfSquares;
};

/// Moments of a tube's slabs over their samples with data, in stored values times slabScale(). One entry for each slab;
/// 0 in a slab without data.
struct SlabMeans {
    std::vector<float> counts;  ///< whole numbers
    std::vector<float> means;
    std::vector<float> squaredDeviations;  ///< sum of squared deviations from the mean
};

/// The slabs of one tube, in one of the three forms.
struct TubeSlabs {
    std::variant<SlabSums, SlabMeans, std::vector<SlabMoments>> slabs;
    double whiteLevel = 1.0;  ///< the value of normalised intensity 1 in SlabSums and SlabMeans
};

/// Stored values above this limit count as the limit, because normalised intensity ends at 1. No value if sums of
/// stored values would not be exact: the voxels are not integers, or the limit would be no integer.
[[nodiscard]] std::optional<std::uint32_t> exactStoredLimit(const Volume& volume);

/// Sums of tubes that lie on voxels. The tubes stand side by side in one row of the grid, so that memory is walked once
/// for all. slabs[t] gets tubes[t].slabs entries. Voxels outside the volume or without data are left out.
void sumSlabs(const Volume& volume, std::uint32_t storedLimit, std::span<const TubeSamples> tubes,
              std::span<SlabSums> slabs);

/// The factor of SlabMeans: 1 for integers, for floats the power of two that brings the white level between 1 and 2.
/// Without it, squares of the smallest and of the largest floats would leave the range of floats.
[[nodiscard]] double slabScale(const Volume& volume);

/// Whether meanSlabs() can take the volume; else sampleSlabs() must. Needs at least 2 voxels in a row and 4 in a slice,
/// at most 16384 along an axis and 8 * 2^20 in a slice, and no 8-bit voxels above the white level.
[[nodiscard]] bool canMeanSlabs(const Volume& volume);

/// Moments of tubes side by side in one row of the grid, anywhere between voxels. Samples are as in sampleSlabs(), the
/// reference, but positions are rounded to 2^-16 voxel, and sums are in single precision.
void meanSlabs(const Volume& volume, Interpolation sampling, std::span<const TubeSamples> tubes,
               std::span<SlabMeans> slabs);

}  // namespace echolucent
