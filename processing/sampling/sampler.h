// Reading a volume between its voxel centres, in double precision: the one plain sampler. What must be fast (the ray
// caster's kernel, the tube cores' slabs) has readers of its own, which tests compare with this one; beside no data
// tube cores take the nearest voxel.
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

    /// Normalised intensity in [0,1] at a place in voxels, clamped to the outermost voxel centres. Trilinear
    /// interpolation gives the weighted mean of the voxels with data around the place, and nothing where they weigh
    /// less than half; the nearest voxel gives nothing where it has no data, and half way between two voxels it is the
    /// one of larger index.
    [[nodiscard]] std::optional<double> intensityAt(const Vec3& voxel) const;

    /// Central difference of trilinear samples, normalised intensity per unit; zero where a voxel it needs has no data.
    /// `reach` is the distance from the place to each sample, units, above 0.
    [[nodiscard]] Vec3 gradientAt(const Vec3& voxel, double reach) const;

private:
    [[nodiscard]] std::optional<double> nearest(const Vec3& voxel) const;
    /// `complete` becomes false where a voxel of more than a vanishing weight has no data.
    [[nodiscard]] std::optional<double> trilinear(const Vec3& voxel, bool& complete) const;

    const Volume& m_volume;
    Interpolation m_interpolation;
};

/// Whether a place in voxels lies in the volume's box, which reaches half a voxel beyond the outermost voxel centres;
/// places beside it by no more than rounding count as inside.
[[nodiscard]] bool inBox(const VolumeGeometry& geometry, const Vec3& voxel);

}  // namespace echolucent
