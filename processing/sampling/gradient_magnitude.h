// Gradient magnitudes of voxels, for two-dimensional OTFs.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "processing/progress.h"
#include "processing/volume/volume.h"

namespace echolucent {

/// Gradient magnitudes g = |grad f| of a volume without edges (FilledVolume::voxels). f is the stored value over the
/// white level, clamped into [0,1]. Derivatives are central differences of the two neighbouring voxels along an axis,
/// per unit (the smallest spacing). They are one-sided at the border of the grid, and 0 along an axis of one voxel.
/// Between voxels g is the trilinear mean of the voxels around.
class GradientMagnitude {
public:
    /// The volume must outlive this object.
    explicit GradientMagnitude(const Volume& filled);
    /// A row of voxels: `magnitudes` gets one value for each voxel along x. Throws std::invalid_argument if it has
    /// another size.
    void row(std::int64_t y, std::int64_t z, std::span<float> magnitudes) const;
    /// At a place in voxels, clamped to the outermost voxel centres. For a few places only; pictures take rows.
    [[nodiscard]] double at(const Vec3& voxel) const;

private:
    const Volume& m_volume;
};

/// The largest gradient magnitude of the voxels with data, and a quantile of them; normalised intensity per unit.
struct GradientRange {
    double largest = 0.0;
    double quantile99 = 0.0;  ///< at least 99 % of the voxels with data have at most this magnitude; exact to 3e-5
};
/// `filled` is filledVoxels(volume). Empty only if the caller set progress.cancel.
[[nodiscard]] std::optional<GradientRange> gradientRange(const Volume& volume, const Volume& filled,
                                                         const Progress& progress = {});

}  // namespace echolucent
