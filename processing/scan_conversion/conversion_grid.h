// The Cartesian grid for the conversion of a polar volume (docs/scan-conversion.md).
#pragma once

#include <cstdint>

#include "processing/scan_conversion/polar_geometry.h"
#include "processing/volume/volume.h"

namespace echolucent {

/// The memory for converted voxels, bytes a phase, if a person asks for no other.
constexpr std::int64_t standardConversionBytes = std::int64_t{64} << 20;
/// The most that a person may ask for, MiB a phase.
constexpr std::int64_t mostConversionMebibytes = std::int64_t{1} << 20;
/// All phases of a study together may take as much as this many phases at their limit.
constexpr std::int64_t conversionPhasesInFull = 8;

/// Bytes of the tables for one row of voxels. All rows together may take as much as the voxels of one phase.
constexpr std::int64_t conversionRowBytes = 28;

/// The memory for the voxels of a study.
struct ConversionMemory {
    std::int64_t bytesPerVoxel = 1;                     ///< 1, 2 or 4
    std::int64_t phases = 1;                            ///< at least 1
    std::int64_t phaseBytes = standardConversionBytes;  ///< limit of one phase, at least 1
    /// How many voxels a phase may have: its own limit, or its share of the limit of all phases if that is less.
    [[nodiscard]] std::int64_t mostVoxels() const;
    /// How many rows of voxels (along x) a grid may have, limited by the memory for their tables.
    [[nodiscard]] std::int64_t mostRows() const;
};

/// A grid with z straight ahead, away from the probe, x across the lines and y across the planes.
struct ConversionGrid {
    /// Its voxels are cubes. The origin is the centre of voxel (0,0,0) in probe mm: no patient is known.
    VolumeGeometry geometry;
    double finestMm = 1.0;         ///< finestResolutionMm(); the grid's spacing if memory allows
    bool limitedByMemory = false;  ///< whether the spacing is wider than finestMm

    /// Rows of voxels, along x.
    [[nodiscard]] std::int64_t rows() const { return geometry.size[1] * geometry.size[2]; }
    [[nodiscard]] Vec3 probeMmFromVoxel(const Vec3& voxel) const { return geometry.patientFromVoxel(voxel); }
};

/// The finest resolution of a polar volume, straight ahead in the middle of the range: the smallest of its step along
/// the beam and the mean distances between neighbouring lines and planes. This and the functions below throw
/// std::invalid_argument if the geometry has a problem (problemOf()).
[[nodiscard]] double finestResolutionMm(const PolarGeometry& polar);

/// The smallest grid around the insonified region. Its spacing is the finest resolution, or as little wider as memory
/// demands. If the region is thinner than the spacing, the grid has one voxel across it.
[[nodiscard]] ConversionGrid conversionGrid(const PolarGeometry& polar, const ConversionMemory& memory = {});
/// The smallest grid around the insonified region with a given spacing, mm. Throws std::invalid_argument if the spacing
/// is not above 0.
[[nodiscard]] ConversionGrid conversionGridOf(const PolarGeometry& polar, double spacingMm);

}  // namespace echolucent
