#include "processing/intensity/intensity_counts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "tests/processing/grids.h"
#include "tests/processing/intensity/counted_volumes.h"

namespace echolucent {
namespace {

TEST(IntensityCounts, CountsManyVoxelsOfEveryTypeAsOneByOne) {
    for (const Volume& volume : scatteredLines()) {
        std::map<double, std::uint64_t> expected;
        std::uint64_t total = 0;
        for (std::int64_t i = 0; i < volume.geometry().voxelCount(); ++i) {
            if (!volume.hasData(i)) continue;
            const double f = volume.normalisedIntensity(i);
            ++expected[volume.typeName() == "float32" ? std::round(f * 65535) / 65535 : f];
            ++total;
        }
        const IntensityCounts counts = intensityCounts(volume);
        EXPECT_EQ(counts.total, total);
        ASSERT_EQ(counts.counts.size(), expected.size()) << volume.typeName();
        std::size_t place = 0;
        for (const auto& entry : expected) {
            EXPECT_EQ(counts.intensities[place], entry.first);
            EXPECT_EQ(counts.counts[place], entry.second);
            ++place;
        }
    }
}

TEST(IntensityCounts, LeavesOutWhatIsNotFiniteWhateverTheMaskSays) {
    const Volume floats(gridOf({6, 1, 1}), std::vector<float>{-3.0f, NAN, 0.5f, 2.0f, INFINITY, -INFINITY}, 1.0);
    for (const Volume& volume : {floats, floats.withDataMask({1, 1, 1, 1, 1, 1})}) {
        const IntensityCounts counts = intensityCounts(volume);
        EXPECT_EQ(counts.total, 3u);
        ASSERT_EQ(counts.counts.size(), 3u);
        EXPECT_EQ(counts.intensities.front(), 0.0);
        EXPECT_NEAR(counts.intensities[1], 0.5, 1e-5);
        EXPECT_EQ(counts.intensities.back(), 1.0);
    }
    EXPECT_EQ(intensityCounts(floats.withDataMask(DataMask(std::vector<std::uint8_t>(6, 0)))).total, 0u);
}

}  // namespace
}  // namespace echolucent
