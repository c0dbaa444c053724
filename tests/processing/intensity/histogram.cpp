#include "processing/intensity/histogram.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/processing/grids.h"
#include "tests/processing/intensity/counted_volumes.h"

namespace echolucent {
namespace {

TEST(Histogram, EveryByteHasItsOwnBinAndWhiteIsInTheLast) {
    std::vector<std::uint8_t> voxels;
    for (int value = 0; value < 256; ++value) voxels.insert(voxels.end(), value % 5, static_cast<std::uint8_t>(value));
    const auto count = static_cast<std::int64_t>(voxels.size());
    const IntensityHistogram histogram = intensityHistogram(Volume(gridOf({count, 1, 1}), voxels));
    EXPECT_EQ(histogram.total, static_cast<std::uint64_t>(count));
    for (std::size_t i = 0; i < 256; ++i) EXPECT_EQ(histogram.counts[i], i % 5);
}

/// Each voxel by itself, whatever the type.
TEST(Histogram, CountsManyVoxelsOfEveryTypeAsOneByOne) {
    for (const Volume& volume : scatteredLines()) {
        IntensityHistogram expected;
        for (std::int64_t i = 0; i < volume.geometry().voxelCount(); ++i) {
            if (!volume.hasData(i)) continue;
            ++expected
                  .counts[std::min<std::size_t>(255, static_cast<std::size_t>(256.0 * volume.normalisedIntensity(i)))];
            ++expected.total;
        }
        EXPECT_EQ(intensityHistogram(volume), expected) << volume.typeName();
    }
}

TEST(Histogram, LeavesOutNoDataAndNotFiniteVoxels) {
    const Volume bytes(gridOf({4, 1, 1}), std::vector<std::uint8_t>{0, 0, 255, 128});
    const IntensityHistogram masked = intensityHistogram(bytes.withDataMask({0, 1, 1, 0}));
    EXPECT_EQ(masked.total, 2u);
    EXPECT_EQ(masked.counts[0], 1u);
    EXPECT_EQ(masked.counts[255], 1u);
    EXPECT_EQ(masked.counts[128], 0u);

    const Volume floats(gridOf({5, 1, 1}), std::vector<float>{-3.0f, std::nanf(""), 0.5f, 2.0f, INFINITY}, 1.0);
    const IntensityHistogram clamped = intensityHistogram(floats);
    EXPECT_EQ(clamped.total, 3u);
    EXPECT_EQ(clamped.counts[0], 1u) << "below 0 counts as 0";
    EXPECT_EQ(clamped.counts[128], 1u);
    EXPECT_EQ(clamped.counts[255], 1u) << "above white counts as white";
}

}  // namespace
}  // namespace echolucent
