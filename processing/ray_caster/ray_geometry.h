// The rays of a picture, and their samples in the rendered region.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "processing/picture/ray_cast_settings.h"
#include "processing/volume/geometry.h"
#include "processing/volume/volume.h"

namespace echolucent::ray_casting {

/// A ray in steps. Step k is the part from voxel position origin + k * step to origin + (k + 1) * step, sampled in its
/// middle. The rendered part lies between `enter` and `leave` (in steps; empty if leave <= enter). Steps first ...
/// last - 1 lie whole within it. The steps before and behind are cut at its ends. The rest of a cut step is sampled in
/// its own middle and counts with its length.
struct Ray {
    Vec3 origin;
    Vec3 step;
    Vec3 direction;  ///< unit, grid mm
    double enter = 0.0, leave = 0.0;
    std::int64_t first = 0, last = 0;
    double depthMm = 0.0;      ///< depth of the origin along camera.frame.forward, from the grid origin
    double depthStepMm = 1.0;  ///< change of that depth with one step

    [[nodiscard]] Vec3 position(std::int64_t sample) const {
        const double steps = static_cast<double>(sample) + 0.5;
        return {origin[0] + step[0] * steps, origin[1] + step[1] * steps, origin[2] + step[2] * steps};
    }
};

/// Part of a step at the beginning or end of a ray, sampled at `at` steps. Its `length` is below 1, and 0 if there is
/// no such part.
template <int lanes>
struct CutSteps {
    alignas(64) double at[lanes], length[lanes];
};

/// Rays of neighbouring pixels, one lane a ray. Members are as in Ray.
template <int lanes>
struct RayBundle {
    alignas(64) double origin[3][lanes];
    alignas(64) double step[3][lanes];
    alignas(64) double enter[lanes], leave[lanes];
    alignas(64) double first[lanes], last[lanes];
    CutSteps<lanes> head, tail;
    alignas(64) double depthMm[lanes], depthStepMm[lanes];

    /// Sets first, last, head and tail from enter and leave.
    __attribute__((always_inline)) inline void cut() {
        // Without branches, so that the compiler makes vectors of it.
        for (int i = 0; i < lanes; ++i) {
            const bool any = enter[i] < leave[i];
            const double begin = any ? enter[i] : 0.0, end = any ? leave[i] : 0.0;
            const double up = std::ceil(begin), down = std::floor(end), left = end - down;
            const bool whole = up <= down;
            const double headEnd = whole ? up : end;
            first[i] = whole ? up : 0.0;
            last[i] = whole ? down : 0.0;
            head.length[i] = headEnd - begin;
            head.at[i] = 0.5 * (begin + headEnd);
            tail.length[i] = whole ? left : 0.0;
            tail.at[i] = 0.5 * (down + end);
        }
    }
    /// Makes a lane a ray without a rendered part.
    void remove(int lane) {
        enter[lane] = leave[lane] = first[lane] = last[lane] = head.length[lane] = tail.length[lane] = 0.0;
    }
};

/// The places with offset + normal . (voxel position) >= 0.
struct HalfSpace {
    Vec3 normal;
    double offset;
};

/// The numbers from which RayGeometry aims and limits rays, for a graphics card that does the same. What bowed fronts
/// leave of the rays is not told.
struct RayPlan {
    bool parallel = true;
    Vec3 first, perColumn, perRow;  ///< parallel: voxels; in perspective a direction of any length, grid mm
    Vec3 step;                      ///< parallel: voxels
    Vec3 eye, forward;              ///< grid mm
    Vec3 low, high;                 ///< voxels
    double stepMm = 1.0;
    double startDepth = 0.0, nearDepth = 0.0, eyeDepth = 0.0;  ///< mm, as the members of RayGeometry
    std::vector<HalfSpace> halfSpaces;
};

/// The rays of one picture.
class RayGeometry {
public:
    /// Throws std::invalid_argument for settings that make no sense, also for those that only the caster reads (light,
    /// mixing, brightness).
    RayGeometry(const VolumeGeometry& geometry, const RayCastSettings& settings);

    [[nodiscard]] Ray rayThrough(int column, int row) const;

    /// Lane i becomes the ray through pixel (column[i], row[i]). It is inlined into the kernels, each compiled for one
    /// instruction set, so that its loops over lanes become vectors of that set.
    template <int lanes>
    __attribute__((always_inline)) inline void fill(RayBundle<lanes>& bundle, const int (&column)[lanes],
                                                    const int (&row)[lanes]) const;

    /// Pixels outside [firstColumn, lastColumn) x [firstRow, lastRow) show nothing of the rendered region.
    struct PixelBox {
        int firstColumn, lastColumn, firstRow, lastRow;
    };
    [[nodiscard]] PixelBox visiblePixels() const;

    /// How far the rays of two neighbouring pixels lie apart in the volume's box at most, mm.
    [[nodiscard]] double widestPixelMm(const VolumeGeometry& geometry) const;

    [[nodiscard]] bool parallel() const { return m_parallel; }
    [[nodiscard]] double stepMm() const { return m_stepMm; }
    [[nodiscard]] RayPlan plan() const;

private:
    void limit(const VolumeGeometry& geometry, const RayCastSettings& settings);
    template <int lanes>
    __attribute__((always_inline)) inline void aimParallel(RayBundle<lanes>& bundle, const int (&column)[lanes],
                                                           const int (&row)[lanes]) const;
    template <int lanes>
    __attribute__((always_inline)) inline void aimPerspective(RayBundle<lanes>& bundle, const int (&column)[lanes],
                                                              const int (&row)[lanes]) const;
    /// Limits the rays, from `enter` on, to the box from m_low to m_high: sets enter and leave.
    template <int lanes>
    __attribute__((always_inline)) inline void clip(RayBundle<lanes>& bundle) const;
    template <int lanes>
    __attribute__((always_inline)) inline void clipAtHalfSpaces(RayBundle<lanes>& bundle) const;
    template <int lanes>
    void cutAtSurface(RayBundle<lanes>& bundle) const;

    static constexpr double endless = 1e15;  ///< steps

    bool m_parallel;
    int m_width, m_height;
    double m_stepMm;
    double m_eyeDepth = 0.0;  ///< in perspective, the depth of the eye from the grid origin
    double m_startDepth;      ///< where rays begin: depth from the grid origin, in perspective distance from the eye
    /// The depth of a front across the view, from the grid origin, in perspective from the eye. Another front is one of
    /// the half spaces.
    double m_nearDepth = -std::numeric_limits<double>::infinity();
    /// Parallel: where the ray of pixel (0,0) begins, and how this place moves with column and row; grid mm. In
    /// perspective: the ray's direction, of any length, and how it changes.
    Vec3 m_first, m_perColumn, m_perRow;
    Vec3 m_eye, m_forward;  ///< grid mm
    Vec3 m_right, m_down;
    Vec3 m_inverseSpacing;
    Vec3 m_step, m_perStep;               ///< the step of every parallel ray, voxels, and 1 / step
    Vec3 m_low, m_high;                   ///< voxels; rendered part of the volume's box
    std::vector<HalfSpace> m_halfSpaces;  ///< only in all of them something may be rendered
    std::optional<CutSurface> m_cutSurface;
};

template <int lanes>
inline void RayGeometry::aimParallel(RayBundle<lanes>& bundle, const int (&column)[lanes],
                                     const int (&row)[lanes]) const {
    for (int axis = 0; axis < 3; ++axis)
        for (int i = 0; i < lanes; ++i) {
            const double x = column[i], y = row[i];
            bundle.origin[axis][i] =
                (m_first[axis] + m_perColumn[axis] * x + m_perRow[axis] * y) * m_inverseSpacing[axis];
            bundle.step[axis][i] = m_step[axis];
        }
    for (int i = 0; i < lanes; ++i) {
        bundle.depthMm[i] = m_startDepth;
        bundle.depthStepMm[i] = m_stepMm;
        bundle.enter[i] = 0.0;
    }
}

template <int lanes>
inline void RayGeometry::aimPerspective(RayBundle<lanes>& bundle, const int (&column)[lanes],
                                        const int (&row)[lanes]) const {
    for (int i = 0; i < lanes; ++i) {
        const double x = column[i], y = row[i];
        const double start[3] = {m_first[0] + m_perColumn[0] * x + m_perRow[0] * y,
                                 m_first[1] + m_perColumn[1] * x + m_perRow[1] * y,
                                 m_first[2] + m_perColumn[2] * x + m_perRow[2] * y};
        const double size = std::sqrt(start[0] * start[0] + start[1] * start[1] + start[2] * start[2]);
        const double cosine = (start[0] * m_forward[0] + start[1] * m_forward[1] + start[2] * m_forward[2]) / size;
        for (int axis = 0; axis < 3; ++axis) {
            const double direction = start[axis] / size;
            bundle.origin[axis][i] = (m_eye[axis] + direction * m_startDepth) * m_inverseSpacing[axis];
            bundle.step[axis][i] = direction * m_inverseSpacing[axis] * m_stepMm;
        }
        bundle.depthMm[i] = m_eyeDepth + m_startDepth * cosine;
        bundle.depthStepMm[i] = m_stepMm * cosine;
        // Towards the picture's corner, a place on a ray has a smaller depth than distance. So the ray may begin before
        // the near plane.
        bundle.enter[i] = std::max((m_nearDepth / cosine - m_startDepth) / m_stepMm, 0.0);
    }
}

template <int lanes>
inline void RayGeometry::fill(RayBundle<lanes>& bundle, const int (&column)[lanes], const int (&row)[lanes]) const {
    if (m_parallel)
        aimParallel(bundle, column, row);
    else
        aimPerspective(bundle, column, row);
    clip(bundle);
    if (!m_halfSpaces.empty()) clipAtHalfSpaces(bundle);
    if (m_cutSurface) cutAtSurface(bundle);
    bundle.cut();
}

template <int lanes>
inline void RayGeometry::clip(RayBundle<lanes>& bundle) const {
    for (int i = 0; i < lanes; ++i) bundle.leave[i] = endless;
    for (int axis = 0; axis < 3; ++axis) {
        const double low = m_low[axis], high = m_high[axis];
        if (m_parallel && m_step[axis] != 0.0) {
            // One division for all rays.
            const double perStep = m_perStep[axis];
            for (int i = 0; i < lanes; ++i) {
                const double a = (low - bundle.origin[axis][i]) * perStep,
                             b = (high - bundle.origin[axis][i]) * perStep;
                bundle.enter[i] = std::max(bundle.enter[i], std::min(a, b));
                bundle.leave[i] = std::min(bundle.leave[i], std::max(a, b));
            }
            continue;
        }
        for (int i = 0; i < lanes; ++i) {
            const double origin = bundle.origin[axis][i], step = bundle.step[axis][i];
            const bool along = step == 0.0, inside = origin >= low && origin < high;
            const double divisor = along ? 1.0 : step;
            const double a = (low - origin) / divisor, b = (high - origin) / divisor;
            const double near = along ? (inside ? -endless : endless) : std::min(a, b);
            const double far = along ? (inside ? endless : -endless) : std::max(a, b);
            bundle.enter[i] = std::max(bundle.enter[i], near);
            bundle.leave[i] = std::min(bundle.leave[i], far);
        }
    }
}

template <int lanes>
inline void RayGeometry::clipAtHalfSpaces(RayBundle<lanes>& bundle) const {
    for (const HalfSpace& space : m_halfSpaces)
        for (int i = 0; i < lanes; ++i) {
            double value = space.offset, slope = 0.0;
            for (int axis = 0; axis < 3; ++axis) {
                value += space.normal[axis] * bundle.origin[axis][i];
                slope += space.normal[axis] * bundle.step[axis][i];
            }
            const double crossing = slope == 0.0 ? 0.0 : -value / slope;
            if (slope > 0.0) bundle.enter[i] = std::max(bundle.enter[i], crossing);
            if (slope < 0.0) bundle.leave[i] = std::min(bundle.leave[i], crossing);
            if (slope == 0.0 && value < 0.0) bundle.leave[i] = -endless;
        }
}

template <int lanes>
void RayGeometry::cutAtSurface(RayBundle<lanes>& bundle) const {
    for (int i = 0; i < lanes; ++i) {
        if (!(bundle.enter[i] < bundle.leave[i])) continue;
        Vec3 point, direction;
        for (int axis = 0; axis < 3; ++axis) {
            point[axis] = bundle.origin[axis][i] / m_inverseSpacing[axis];
            direction[axis] = bundle.step[axis][i] / (m_inverseSpacing[axis] * m_stepMm);
        }
        const auto left =
            m_cutSurface->firstLeft(point, direction, {bundle.enter[i] * m_stepMm, bundle.leave[i] * m_stepMm});
        bundle.leave[i] = left ? left->end / m_stepMm : -endless;
        if (left) bundle.enter[i] = left->begin / m_stepMm;
    }
}

}  // namespace echolucent::ray_casting
