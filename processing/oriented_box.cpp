#include "processing/oriented_box.h"

#include <cmath>

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

}  // namespace echolucent
