// A box that may stand obliquely in a volume.
#pragma once

#include <array>

#include "processing/view_frame.h"
#include "processing/volume/geometry.h"

namespace echolucent {

/// Places are grid mm. Its axes need not be the grid's.
struct OrientedBox {
    Vec3 centreMm{0, 0, 0};
    ViewFrame axes{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    Vec3 sizeMm{1, 1, 1};  ///< along axes.right, axes.down and axes.forward, each above 0

    /// Half the size, within which a place lies along each of the axes.
    [[nodiscard]] Vec3 halfMm() const { return sizeMm * 0.5; }
    /// A place of the grid, mm from the box's centre along its own axes.
    [[nodiscard]] Vec3 inBox(const Vec3& gridMm) const;
    /// The other way round.
    [[nodiscard]] Vec3 inGrid(const Vec3& boxMm) const;
    /// Whether a place of the grid lies in the box or on its faces.
    [[nodiscard]] bool contains(const Vec3& gridMm) const;
    /// Corner i lies on the side of larger right where bit 0 is set, of larger down for bit 1, of larger forward for
    /// bit 2; grid mm.
    [[nodiscard]] std::array<Vec3, 8> corners() const;

    friend bool operator==(const OrientedBox&, const OrientedBox&) = default;
};

}  // namespace echolucent
