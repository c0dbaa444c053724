// How far away the border of the data is, by bricks: against its definition.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "processing/ray_caster/packed/border_space.h"
#include "processing/volume/filled_volume.h"
#include "tests/inputs.h"

namespace echolucent::ray_casting {
namespace {

/// A ball of data in a grid of which no edge is a whole number of bricks, and a hole in it.
Volume ballWithHole() {
    VolumeGeometry geometry;
    geometry.size = {97, 85, 110};
    std::vector<std::uint8_t> voxels(static_cast<std::size_t>(geometry.voxelCount()), 100), mask(voxels.size());
    for (std::int64_t z = 0; z < geometry.size[2]; ++z)
        for (std::int64_t y = 0; y < geometry.size[1]; ++y)
            for (std::int64_t x = 0; x < geometry.size[0]; ++x) {
                const auto square = [](std::int64_t a) { return a * a; };
                const bool ball = square(x - 50) + square(y - 44) + square(z - 60) < square(43);
                const bool hole = square(x - 60) + square(y - 40) + square(z - 70) < square(3);
                mask[static_cast<std::size_t>(geometry.offset(x, y, z))] = ball && !hole ? 1 : 0;
            }
    return Volume(geometry, std::move(voxels)).withDataMask(std::move(mask));
}

using Brick = std::array<std::int64_t, 3>;

bool meetsBorder(const Volume& presence, const Brick& brick) {
    const VolumeGeometry& geometry = presence.geometry();
    Brick first, last;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        first[axis] = std::clamp<std::int64_t>(4 * brick[axis] - 1, 0, geometry.size[axis] - 1);
        last[axis] = std::min<std::int64_t>(4 * brick[axis] + 3, geometry.size[axis] - 1);
    }
    for (std::int64_t z = first[2]; z <= last[2]; ++z)
        for (std::int64_t y = first[1]; y <= last[1]; ++y)
            for (std::int64_t x = first[0]; x <= last[0]; ++x)
                if (presence.storedValue(geometry.offset(x, y, z)) < PresenceUse::allFrom) return true;
    return false;
}

TEST(BorderSpace, DistancesAreTheLargestOfTheAxesToTheNearestBorder) {
    const Volume volume = ballWithHole(), presence = *presenceIn(volume);
    const BorderSpace space{PackedPresence(volume)};
    std::vector<Brick> all, borders;
    for (std::int64_t z = 0; z < space.size()[2]; ++z)
        for (std::int64_t y = 0; y < space.size()[1]; ++y)
            for (std::int64_t x = 0; x < space.size()[0]; ++x) {
                all.push_back({x, y, z});
                if (meetsBorder(presence, all.back())) borders.push_back(all.back());
            }
    int farthest = 0;
    ASSERT_EQ(space.distances().size(), all.size());
    for (std::size_t i = 0; i < all.size(); i += takesSomeInputs ? 7 : 1) {
        std::int64_t nearest = BorderSpace::farthest;
        for (const Brick& border : borders)
            nearest = std::min(nearest, std::max({std::abs(all[i][0] - border[0]), std::abs(all[i][1] - border[1]),
                                                  std::abs(all[i][2] - border[2])}));
        ASSERT_EQ(space.distances()[i], nearest) << all[i][0] << ' ' << all[i][1] << ' ' << all[i][2];
        farthest = std::max(farthest, int{space.distances()[i]});
    }
    EXPECT_GE(farthest, 3) << "nothing here is far from the border";
}

TEST(BorderSpace, IsEmptyWhereAllVoxelsCarryData) {
    VolumeGeometry geometry;
    geometry.size = {9, 9, 9};
    const BorderSpace space{PackedPresence(Volume(geometry, std::vector<std::uint8_t>(9 * 9 * 9, 1)))};
    EXPECT_TRUE(space.distances().empty());
}

}  // namespace
}  // namespace echolucent::ray_casting
