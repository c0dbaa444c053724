// A box that may be oblique in a volume.
#pragma once

#include <array>
#include <vector>

#include "processing/viewpoint/view_frame.h"
#include "processing/volume/geometry.h"
#include "processing/volume/volume.h"

namespace echolucent {

/// Places are in grid mm. The box's axes need not be the grid's.
struct OrientedBox {
    Vec3 centreMm{0, 0, 0};
    ViewFrame axes{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    Vec3 sizeMm{1, 1, 1};  ///< along axes.right, axes.down and axes.forward, each above 0

    /// Half the size along each of the axes.
    [[nodiscard]] Vec3 halfMm() const { return sizeMm * 0.5; }
    /// A place of the grid, in mm from the box's centre along the box's axes.
    [[nodiscard]] Vec3 inBox(const Vec3& gridMm) const;
    /// The reverse of inBox().
    [[nodiscard]] Vec3 inGrid(const Vec3& boxMm) const;
    /// Whether a place of the grid lies in the box or on its faces.
    [[nodiscard]] bool contains(const Vec3& gridMm) const;
    /// The corners, in grid mm. Bit 0 of a corner's index is set on the side of larger right, bit 1 for down, bit 2 for
    /// forward.
    [[nodiscard]] std::array<Vec3, 8> corners() const;

    /// How far the box reaches along a direction, from its first to its last corner, mm.
    [[nodiscard]] double extentAlong(const Vec3& direction) const;

    friend bool operator==(const OrientedBox&, const OrientedBox&) = default;
};

/// The data box as an oriented box.
[[nodiscard]] OrientedBox orientedBoxOf(const DataBox& box);

/// A plane that cuts away all before it. What is left lies at `depthMm` or more along `inwards`, counted from the grid
/// origin.
struct CuttingFace {
    Vec3 inwards{0, 0, 1};  ///< unit, grid mm
    double depthMm = 0.0;
    friend bool operator==(const CuttingFace&, const CuttingFace&) = default;
};

/// The faces of a box that cut something off a volume's grid. A face that only touches the grid's box, to a billionth
/// of its extent, cuts nothing. So a box around the whole volume changes no bit of a result.
[[nodiscard]] std::vector<CuttingFace> facesThatCut(const OrientedBox& box, const VolumeGeometry& geometry);

/// The data mask of a volume, one byte a voxel. Voxels with centres outside the box count as no data.
[[nodiscard]] std::vector<std::uint8_t> dataMaskWithin(const OrientedBox& box, const Volume& volume);

}  // namespace echolucent
