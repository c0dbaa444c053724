// Reading a volume between its voxel centres, in double.
#pragma once

#include <optional>
#include <vector>

#include "processing/ray_caster.h"
#include "processing/volume/volume.h"

namespace echolucent::plain_casting {

class Sampler {
public:
    /// Keeps the stored values as float, which holds every voxel type exactly, NaN where there is no data.
    Sampler(const Volume& volume, Interpolation interpolation);

    /// Normalised intensity in [0,1] at a place in voxels, clamped to the outermost voxel centres; none where there is
    /// no data, or for trilinear samples where voxels with data weigh less than half.
    [[nodiscard]] std::optional<double> intensityAt(const Vec3& voxel) const;

    /// Central difference of trilinear samples, normalised intensity per unit; zero where a voxel it needs has no data.
    /// reach: units, > 0.
    [[nodiscard]] Vec3 gradientAt(const Vec3& voxel, double reach) const;

private:
    [[nodiscard]] std::optional<double> nearest(const Vec3& voxel) const;
    /// `complete` becomes false where a voxel of more than a vanishing weight has no data.
    [[nodiscard]] std::optional<double> trilinear(const Vec3& voxel, bool& complete) const;

    VolumeGeometry m_geometry;
    double m_whiteLevel;
    Interpolation m_interpolation;
    std::vector<float> m_stored;
};

}  // namespace echolucent::plain_casting
