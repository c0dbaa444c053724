// Which rays a picture needs, and which of their samples lie in the volume.
#pragma once

#include <cstdint>

#include "processing/geometry.h"
#include "processing/ray_caster.h"
#include "processing/volume.h"

namespace echolucent::ray_casting {

/// Sample k of a ray, k = first ... last - 1, lies at voxel position origin + (k + 0.5) * step. The samples of
/// innerFirst ... innerLast - 1 lie between voxel centres on all axes (with a hair to spare at the far side), so that
/// the eight voxels around them exist, and what is read ahead of them.
struct Ray {
    Vec3 origin;
    Vec3 step;
    Vec3 direction;  ///< unit, grid mm
    std::int64_t first = 0, last = 0;
    std::int64_t innerFirst = 0, innerLast = 0;

    [[nodiscard]] Vec3 position(std::int64_t sample) const {
        const double steps = static_cast<double>(sample) + 0.5;
        return {origin[0] + step[0] * steps, origin[1] + step[1] * steps, origin[2] + step[2] * steps};
    }
};

/// The rays of one picture.
class RayGeometry {
public:
    /// Throws std::invalid_argument for a size, step or camera that makes no sense.
    RayGeometry(const VolumeGeometry& geometry, const RayCastSettings& settings);

    [[nodiscard]] Ray rayThrough(int column, int row) const;

private:
    [[nodiscard]] Ray parallelRay(const Vec3& offset) const;
    [[nodiscard]] Ray perspectiveRay(const Vec3& offset) const;
    void clip(Ray& ray, double firstStep) const;

    VolumeGeometry m_geometry;
    Camera m_camera;
    int m_width, m_height;
    double m_pixel;  ///< mm a pixel; perspective: at distance 1 from the eye
    double m_stepMm;
    double m_startDepth;  ///< depth along forward of sample plane -0.5, from the grid origin; perspective: from the eye
    double m_nearDepth;   ///< the near plane's depth, likewise
    Vec3 m_inverseSpacing;
    Vec3 m_innerMax;   ///< voxels; inner samples lie before it on each axis
    Vec3 m_stepVoxel;  ///< parallel rays only
};

}  // namespace echolucent::ray_casting
