#include "processing/volume/bit_grid.h"

#include <gtest/gtest.h>

#include <deque>
#include <random>

namespace echolucent {
namespace {

using GridSize = std::array<std::int64_t, 3>;
using Place = std::array<std::int64_t, 3>;

const GridSize sizes[] = {{1, 1, 1}, {64, 3, 2}, {63, 4, 5}, {65, 5, 4}, {130, 6, 7}, {9, 1, 30}, {200, 2, 1}};
constexpr Place steps[] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};

BitGrid randomGrid(const GridSize& size, double share, unsigned seed) {
    std::mt19937 random(seed);
    BitGrid grid(size);
    for (std::int64_t z = 0; z < size[2]; ++z)
        for (std::int64_t y = 0; y < size[1]; ++y)
            for (std::int64_t x = 0; x < size[0]; ++x)
                if (static_cast<double>(random()) < share * 4294967296.0) grid.set(x, y, z);
    return grid;
}

bool holds(const GridSize& size, const Place& p) {
    return p[0] >= 0 && p[0] < size[0] && p[1] >= 0 && p[1] < size[1] && p[2] >= 0 && p[2] < size[2];
}

template <typename Body>
void forEachPlace(const GridSize& size, const Body& body) {
    for (std::int64_t z = 0; z < size[2]; ++z)
        for (std::int64_t y = 0; y < size[1]; ++y)
            for (std::int64_t x = 0; x < size[0]; ++x) body(Place{x, y, z});
}

bool member(const BitGrid& grid, const Place& p) { return grid.at(p[0], p[1], p[2]); }

TEST(BitGrid, DilatesAndErodesLikeTheObviousRoute) {
    for (const GridSize& size : sizes)
        for (const double share : {0.1, 0.9}) {
            const BitGrid grid = randomGrid(size, share, 7);
            const BitGrid dilated = grid.dilated(), eroded = grid.eroded();
            std::int64_t dilatedCount = 0;
            forEachPlace(size, [&](const Place& p) {
                bool any = member(grid, p), all = member(grid, p);
                for (const Place& step : steps) {
                    const Place q{p[0] + step[0], p[1] + step[1], p[2] + step[2]};
                    if (!holds(size, q)) continue;
                    any = any || member(grid, q);
                    all = all && member(grid, q);
                }
                ASSERT_EQ(member(dilated, p), any);
                ASSERT_EQ(member(eroded, p), all);
                dilatedCount += any;
            });
            EXPECT_EQ(dilated.count(), dilatedCount) << "no member beyond the row's end";
        }
}

TEST(BitGrid, FindsWhatIsConnectedToTheBorder) {
    for (const GridSize& size : sizes)
        for (const double share : {0.2, 0.45, 0.6, 0.95})
            for (unsigned seed = 1; seed <= 3; ++seed) {
                const BitGrid grid = randomGrid(size, share, seed);
                BitGrid expected(size);
                std::deque<Place> waiting;
                const auto enter = [&](const Place& p) {
                    if (!holds(size, p) || !member(grid, p) || member(expected, p)) return;
                    expected.set(p[0], p[1], p[2]);
                    waiting.push_back(p);
                };
                forEachPlace(size, [&](const Place& p) {
                    for (std::size_t axis = 0; axis < 3; ++axis)
                        if (p[axis] == 0 || p[axis] == size[axis] - 1) enter(p);
                });
                while (!waiting.empty()) {
                    const Place p = waiting.front();
                    waiting.pop_front();
                    for (const Place& step : steps) enter({p[0] + step[0], p[1] + step[1], p[2] + step[2]});
                }
                const BitGrid found = grid.connectedToBorder();
                forEachPlace(size, [&](const Place& p) { ASSERT_EQ(member(found, p), member(expected, p)); });
            }
}

TEST(BitGrid, FollowsAWindingCorridor) {
    // There is one corridor that turns back at each end, through 40 slices of a comb: the only way in is at its
    // beginning.
    const GridSize size{133, 83, 5};
    BitGrid grid(size);
    for (std::int64_t y = 1; y < 82; y += 2) {
        for (std::int64_t x = 1; x < 132; ++x) grid.set(x, y, 2);
        if (y + 2 < 82) grid.set((y / 2) % 2 == 0 ? 131 : 1, y + 1, 2);
    }
    EXPECT_EQ(grid.connectedToBorder().count(), 0);
    grid.set(1, 0, 2);
    EXPECT_EQ(grid.connectedToBorder().count(), grid.count());
}

}  // namespace
}  // namespace echolucent
