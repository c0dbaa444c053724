#include "processing/parallel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <vector>

#include "processing/per_thread.h"

namespace echolucent {
namespace {

TEST(ParallelFor, CallsTheBodyOnceForEveryIndex) {
    for (const int last : {-3, 0, 1, 7, 1000}) {
        std::vector<std::atomic<int>> calls(1003);
        parallelFor(-3, last, [&](int index) { ++calls[static_cast<std::size_t>(index + 3)]; });
        const auto counted = std::ranges::count_if(calls, [](const auto& count) { return count == 1; });
        EXPECT_EQ(counted, last + 3) << last;
    }
}

TEST(ParallelFor, SplitsARangeIntoPartsThatAreTheWhole) {
    std::vector<std::atomic<int>> calls(1000);
    parallelFor(LoopRange<std::size_t>(0, calls.size(), 64), [&](const LoopRange<std::size_t>& part) {
        for (std::size_t i = part.begin(); i < part.end(); ++i) ++calls[i];
    });
    EXPECT_TRUE(std::ranges::all_of(calls, [](const auto& count) { return count == 1; }));
    parallelFor(LoopRange<std::int64_t>(5, 5), [](const auto&) { ADD_FAILURE() << "an empty range has no part"; });
}

TEST(ParallelFor, SplitsARectangleIntoTilesThatAreTheWhole) {
    constexpr int rows = 37, columns = 23;
    std::vector<std::atomic<int>> calls(rows * columns);
    parallelFor(LoopRectangle<int>(rows, columns), [&](const LoopRectangle<int>& tile) {
        for (int row = tile.rows().begin(); row < tile.rows().end(); ++row)
            for (int column = tile.columns().begin(); column < tile.columns().end(); ++column)
                ++calls[static_cast<std::size_t>(row * columns + column)];
    });
    EXPECT_TRUE(std::ranges::all_of(calls, [](const auto& count) { return count == 1; }));
    parallelFor(LoopRectangle<int>(0, columns), [](const auto&) { ADD_FAILURE() << "an empty rectangle has no tile"; });
}

TEST(ParallelFor, ThrowsToTheCallerWhatABodyThrows) {
    EXPECT_THROW(parallelFor(0, 100,
                             [](int index) {
                                 if (index == 40) throw std::invalid_argument("40");
                             }),
                 std::invalid_argument);
}

TEST(PerThreadValue, IsMadeForEachThreadThatAsks) {
    std::atomic<int> made = 0;
    PerThread<int> values([&] { return ++made; });
    parallelFor(0, 1000, [&](int) { EXPECT_GT(values.local(), 0); });
    EXPECT_GE(made, 1);
    EXPECT_EQ(values.local(), values.local());
}

}  // namespace
}  // namespace echolucent
