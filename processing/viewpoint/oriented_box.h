// A box that may stand obliquely in a volume.
#pragma once

#include <array>
#include <vector>

#include "processing/viewpoint/view_frame.h"
#include "processing/volume/geometry.h"
#include "processing/volume/volume.h"

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

    /// How far the box reaches along a direction, from its first to its last corner, mm.
    [[nodiscard]] double extentAlong(const Vec3& direction) const;

    friend bool operator==(const OrientedBox&, const OrientedBox&) = default;
};

/// The box that holds a data box exactly.
[[nodiscard]] OrientedBox orientedBoxOf(const DataBox& box);

/// A face of a box: what lies in the box is at `depthMm` or more along `inwards`, counted from the grid origin.
struct CuttingFace {
    Vec3 inwards{0, 0, 1};  ///< unit, grid mm
    double depthMm = 0.0;
};

/// The faces of a box that cut something off a volume's grid. One that only touches the grid's box, to a billionth of
/// its extent, is none of them, so that a box around the whole volume changes no bit of a result.
[[nodiscard]] std::vector<CuttingFace> facesThatCut(const OrientedBox& box, const VolumeGeometry& geometry);

/// The data mask of a volume without the voxels whose centres lie outside a box: one byte a voxel.
[[nodiscard]] std::vector<std::uint8_t> dataMaskWithin(const OrientedBox& box, const Volume& volume);

}  // namespace echolucent
