#include "processing/viewpoint/oriented_box.h"

#include <cmath>

#include "processing/parallel.h"

namespace echolucent {

Vec3 OrientedBox::inBox(const Vec3& gridMm) const {
    const Vec3 from = gridMm - centreMm;
    return {axes.right.dot(from), axes.down.dot(from), axes.forward.dot(from)};
}

Vec3 OrientedBox::inGrid(const Vec3& boxMm) const {
    return centreMm + axes.right * boxMm[0] + axes.down * boxMm[1] + axes.forward * boxMm[2];
}

bool OrientedBox::contains(const Vec3& gridMm) const {
    const Vec3 place = inBox(gridMm);
    for (int axis = 0; axis < 3; ++axis)
        if (!(std::abs(place[axis]) <= 0.5 * sizeMm[axis])) return false;
    return true;
}

std::array<Vec3, 8> OrientedBox::corners() const {
    std::array<Vec3, 8> all;
    for (std::size_t i = 0; i < all.size(); ++i) {
        Vec3 corner = halfMm();
        for (int axis = 0; axis < 3; ++axis)
            if (!(i >> axis & 1U)) corner[axis] = -corner[axis];
        all[i] = inGrid(corner);
    }
    return all;
}

double OrientedBox::extentAlong(const Vec3& direction) const {
    return std::abs(direction.dot(axes.right)) * sizeMm[0] + std::abs(direction.dot(axes.down)) * sizeMm[1] +
           std::abs(direction.dot(axes.forward)) * sizeMm[2];
}

OrientedBox orientedBoxOf(const DataBox& box) { return {.centreMm = box.centreMm(), .sizeMm = box.sizeMm()}; }

std::vector<CuttingFace> facesThatCut(const OrientedBox& box, const VolumeGeometry& geometry) {
    constexpr double touching = 1e-9;  // of the grid's extent
    std::vector<CuttingFace> faces;
    const Vec3 axes[] = {box.axes.right, box.axes.down, box.axes.forward};
    for (int axis = 0; axis < 3; ++axis)
        for (const Vec3& inwards : {axes[axis], -axes[axis]}) {
            const CuttingFace face{inwards, inwards.dot(box.centreMm) - 0.5 * box.sizeMm[axis]};
            const auto grid = geometry.depthsAlong(inwards);
            if (face.depthMm > grid.nearest + touching * (grid.farthest - grid.nearest)) faces.push_back(face);
        }
    return faces;
}

std::vector<std::uint8_t> dataMaskWithin(const OrientedBox& box, const Volume& volume) {
    const VolumeGeometry& geometry = volume.geometry();
    std::vector<std::uint8_t> mask(static_cast<std::size_t>(geometry.voxelCount()));
    parallelFor(LoopRange<std::int64_t>(0, geometry.size[1] * geometry.size[2], 16), [&](const auto& rows) {
        for (std::int64_t row = rows.begin(); row < rows.end(); ++row) {
            const std::int64_t y = row % geometry.size[1], z = row / geometry.size[1];
            const std::int64_t first = geometry.offset(0, y, z);
            for (std::int64_t x = 0; x < geometry.size[0]; ++x)
                if (volume.hasData(first + x) &&
                    box.contains(geometry.gridMmFromVoxel(
                        {static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)})))
                    mask[static_cast<std::size_t>(first + x)] = 1;
        }
    });
    return mask;
}

}  // namespace echolucent
