// Reads a volume between its voxel centres, in double precision: the one plain sampler. The ray caster's kernel and the
// tube cores' slabs must be fast and have readers of their own. Tests compare those with this one. Beside no data, tube
// cores take the nearest voxel.
#pragma once

#include <optional>

#include "processing/sampling/interpolation.h"
#include "processing/volume/volume.h"

namespace echolucent {

class VolumeSampler {
public:
    /// The volume must outlive the sampler.
    explicit VolumeSampler(const Volume& volume, Interpolation interpolation = Interpolation::trilinear)
        : m_volume(volume), m_interpolation(interpolation) {}

    /// Normalised intensity in [0,1] at a place in voxels, clamped to the outermost voxel centres. Trilinear: the
    /// weighted mean of the voxels with data around the place, empty if they weigh less than half. Nearest: the nearest
    /// voxel, empty if it has no data; half way between two voxels, the one of larger index.
    [[nodiscard]] std::optional<double> intensityAt(const Vec3& voxel) const;

    /// Central difference of trilinear samples, normalised intensity per unit. Zero if a voxel of more than vanishing
    /// weight in these samples has no data. `reach` is the distance from the place to each sample, units, above 0.
    [[nodiscard]] Vec3 gradientAt(const Vec3& voxel, double reach) const;

private:
    [[nodiscard]] std::optional<double> nearest(const Vec3& voxel) const;
    /// `complete` becomes false if a voxel without data has more than a vanishing weight.
    [[nodiscard]] std::optional<double> trilinear(const Vec3& voxel, bool& complete) const;

    const Volume& m_volume;
    Interpolation m_interpolation;
};

/// Whether a place in voxels lies in the volume's box. The box reaches half a voxel beyond the outermost voxel centres.
/// A place that misses it by rounding only counts as inside.
[[nodiscard]] bool inBox(const VolumeGeometry& geometry, const Vec3& voxel);

}  // namespace echolucent
