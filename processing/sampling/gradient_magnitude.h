// Gradient magnitudes of voxels, as two-dimensional OTFs read them.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "processing/progress.h"
#include "processing/volume/volume.h"

namespace echolucent {

/// Gradient magnitudes of the voxels of a volume without edges (FilledVolume::voxels): g = |grad f|, f the stored value
/// over the white level, clamped into [0,1]. Derivatives are central differences of the two neighbouring voxels along
/// an axis, one-sided at the border of the grid, 0 along an axis of one voxel; per unit (the smallest spacing). Between
/// voxels g is the trilinear mean of the voxels around.
class GradientMagnitude {
public:
    /// The volume must outlive it.
    explicit GradientMagnitude(const Volume& filled);
    /// Of a row of voxels, `magnitudes` one for each voxel along x.
    void row(std::int64_t y, std::int64_t z, std::span<float> magnitudes) const;
    /// At a place in voxels, clamped to the outermost voxel centres. For a few places; a picture takes rows.
    [[nodiscard]] double at(const Vec3& voxel) const;

private:
    const Volume& m_volume;
};

/// The largest gradient magnitude of the voxels with data, and a quantile of them; normalised intensity per unit.
struct GradientRange {
    double largest = 0.0;
    double quantile99 = 0.0;  ///< 99 % of the voxels with data have at most this one; exact to 3e-5
};
/// `filled` is filledVoxels(volume). The result is empty only where progress.cancel was raised.
[[nodiscard]] std::optional<GradientRange> gradientRange(const Volume& volume, const Volume& filled,
                                                         const Progress& progress = {});

}  // namespace echolucent
