// The slabs of a row of tube cores, summed up many at a time: exact integers where samples are voxels, single precision
// where they are interpolated. One lane of a vector is one slab, and its samples are added in a fixed order, so that
// the results have the same bits on any instruction set and any number of threads.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "processing/tube_core/slabs/tube_samples.h"

namespace echolucent {

/// Sums over the data voxels of a tube's slabs, in stored values: exact. One entry a slab.
struct SlabSums {
    std::vector<std::int32_t> counts;
    std::vector<std::int32_t> sums;  ///< at most 32^2 * 65535
    std::vector<std::uint64_t> sumsOfSquares;
};

/// Moments of a tube's slabs over the samples that have data, in stored values times slabScale(). One entry a slab; a
/// slab without data has zeros.
struct SlabMeans {
    std::vector<float> counts;  ///< whole numbers
    std::vector<float> means;
    std::vector<float> squaredDeviations;  ///< sum of squared deviations from the mean
};

/// The slabs of one tube, by whichever route they were summed up.
struct TubeSlabs {
    std::variant<SlabSums, SlabMeans, std::vector<SlabMoments>> slabs;
    double whiteLevel = 1.0;  ///< what normalised intensity 1 is in SlabSums and SlabMeans
};

/// Stored values above this count as this (normalised intensity ends at 1). Nothing where the volume's voxels are not
/// integers, or where its white level is not one and that matters, so that sums of stored values would not be exact.
[[nodiscard]] std::optional<std::uint32_t> exactStoredLimit(const Volume& volume);

/// Sums of tubes that lie on voxels, side by side in one row of the grid, so that memory is walked once for all of
/// them. slabs[t] is filled with tubes[t].slabs entries. Voxels outside the volume or without data are left out.
void sumSlabs(const Volume& volume, std::uint32_t storedLimit, std::span<const TubeSamples> tubes,
              std::span<SlabSums> slabs);

/// What SlabMeans are multiplied by: 1 for integers, for floats the power of two that brings the white level between 1
/// and 2. Squares of the smallest and of the largest floats would not be floats.
[[nodiscard]] double slabScale(const Volume& volume);

/// Whether meanSlabs() can take the volume; else sampleSlabs() must: fewer than 2 voxels along x or 4 in all, axes
/// beyond 16384 voxels, slices beyond 8 million voxels, or 8-bit voxels above the white level.
[[nodiscard]] bool canMeanSlabs(const Volume& volume);

/// Moments of tubes side by side in one row of the grid, anywhere between voxels; sampled as sampleSlabs() does, which
/// is the reference, with positions rounded to 2^-16 voxel and sums in single precision.
void meanSlabs(const Volume& volume, Interpolation sampling, std::span<const TubeSamples> tubes,
               std::span<SlabMeans> slabs);

}  // namespace echolucent
