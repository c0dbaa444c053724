#include "processing/volume/intensity_counts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace echolucent {
namespace {

VolumeGeometry lineOf(std::int64_t voxels) {
    VolumeGeometry geometry;
    geometry.size = {voxels, 1, 1};
    return geometry;
}

TEST(IntensityCounts, CountsManyVoxelsOfEveryTypeAsOneByOne) {
    constexpr std::int64_t count = 10007;  // no multiple of anything
    std::vector<std::uint8_t> bytes, mask;
    std::vector<std::uint16_t> words;
    std::vector<float> floats;
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint32_t random = i * 2654435761U >> 7;
        bytes.push_back(static_cast<std::uint8_t>(random));
        words.push_back(static_cast<std::uint16_t>(random));
        floats.push_back(static_cast<float>(random % 7001) - 100.0F);
        mask.push_back(random % 3 != 0 ? 1 : 0);
    }
    for (const Volume& volume : {Volume(lineOf(count), bytes, 200.0), Volume(lineOf(count), words, 60000.0),
                                 Volume(lineOf(count), floats, 5000.0)}) {
        const Volume masked = volume.withDataMask(mask);
        for (const Volume* each : {&volume, &masked}) {
            std::map<double, std::uint64_t> expected;
            std::uint64_t total = 0;
            for (std::int64_t i = 0; i < count; ++i) {
                if (!each->hasData(i)) continue;
                const double f = each->normalisedIntensity(i);
                ++expected[each->typeName() == "float32" ? std::round(f * 65535) / 65535 : f];
                ++total;
            }
            const IntensityCounts counts = intensityCounts(*each);
            EXPECT_EQ(counts.total, total);
            ASSERT_EQ(counts.counts.size(), expected.size()) << each->typeName();
            std::size_t place = 0;
            for (const auto& entry : expected) {
                EXPECT_EQ(counts.intensities[place], entry.first);
                EXPECT_EQ(counts.counts[place], entry.second);
                ++place;
            }
        }
    }
}

TEST(IntensityCounts, LeavesOutWhatIsNotFiniteWhateverTheMaskSays) {
    const Volume floats(lineOf(6), std::vector<float>{-3.0f, NAN, 0.5f, 2.0f, INFINITY, -INFINITY}, 1.0);
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
