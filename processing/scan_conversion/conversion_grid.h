// The Cartesian grid that a polar volume is converted to (docs/scan-conversion.md).
#pragma once

#include <cstdint>

#include "processing/scan_conversion/polar_geometry.h"
#include "processing/volume/volume.h"

namespace echolucent {

/// How much memory converted voxels may take where a person does not say otherwise, bytes a phase.
constexpr std::int64_t standardConversionBytes = std::int64_t{64} << 20;
/// No person may ask for more, MiB a phase.
constexpr std::int64_t mostConversionMebibytes = std::int64_t{1} << 20;
/// All phases of a study together may take as much as this many phases.
constexpr std::int64_t conversionPhasesInFull = 8;

/// What the tables of one row of voxels take while voxels are converted. All rows together may take as much as the
/// voxels of one phase.
constexpr std::int64_t conversionRowBytes = 28;

/// What voxels of a study take.
struct ConversionMemory {
    std::int64_t bytesPerVoxel = 1;                     ///< 1, 2 or 4
    std::int64_t phases = 1;                            ///< at least 1
    std::int64_t phaseBytes = standardConversionBytes;  ///< limit of one phase, at least 1
    /// How many voxels a phase may have: the limit of one phase, and its share of that of all phases.
    [[nodiscard]] std::int64_t mostVoxels() const;
    /// How many rows of voxels (along x) a grid may have, by what their tables take.
    [[nodiscard]] std::int64_t mostRows() const;
};

/// A grid whose z axis runs straight ahead, away from the probe, x across the lines and y across the planes.
struct ConversionGrid {
    /// Its voxels are cubes. The origin is the centre of voxel (0,0,0) in probe mm: no patient is known.
    VolumeGeometry geometry;
    double finestMm = 1.0;         ///< finestResolutionMm(), which the spacing is where memory allows
    bool limitedByMemory = false;  ///< whether the spacing is wider than that

    /// Rows of voxels, along x.
    [[nodiscard]] std::int64_t rows() const { return geometry.size[1] * geometry.size[2]; }
    [[nodiscard]] Vec3 probeMmFromVoxel(const Vec3& voxel) const { return geometry.patientFromVoxel(voxel); }
};

/// The finest resolution of a polar volume: the smallest of its step along the beam and of the mean distances between
/// neighbouring lines and planes, taken straight ahead in the middle of the range. A geometry with a problem is a
/// broken contract, here and below.
[[nodiscard]] double finestResolutionMm(const PolarGeometry& polar);

/// The smallest grid around the insonified region whose spacing is the finest resolution, or as little wider as memory
/// demands. A region that is thinner than that spacing leaves one voxel across.
[[nodiscard]] ConversionGrid conversionGrid(const PolarGeometry& polar, const ConversionMemory& memory = {});
/// The same with a given spacing, mm.
[[nodiscard]] ConversionGrid conversionGridOf(const PolarGeometry& polar, double spacingMm);

}  // namespace echolucent
