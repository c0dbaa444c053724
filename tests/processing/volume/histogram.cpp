#include "processing/volume/histogram.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace echolucent {
namespace {

VolumeGeometry lineOf(std::int64_t voxels) {
    VolumeGeometry geometry;
    geometry.size = {voxels, 1, 1};
    return geometry;
}

TEST(Histogram, EveryByteHasItsOwnBinAndWhiteIsInTheLast) {
    std::vector<std::uint8_t> voxels;
    for (int value = 0; value < 256; ++value) voxels.insert(voxels.end(), value % 5, static_cast<std::uint8_t>(value));
    const auto count = static_cast<std::int64_t>(voxels.size());
    const IntensityHistogram histogram = intensityHistogram(Volume(lineOf(count), voxels));
    EXPECT_EQ(histogram.total, static_cast<std::uint64_t>(count));
    for (std::size_t i = 0; i < 256; ++i) EXPECT_EQ(histogram.counts[i], i % 5);
}

/// Each voxel by itself, whatever the type.
TEST(Histogram, CountsManyVoxelsOfEveryTypeAsOneByOne) {
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
            IntensityHistogram expected;
            for (std::int64_t i = 0; i < count; ++i) {
                if (!each->hasData(i)) continue;
                ++expected.counts[std::min<std::size_t>(
                    255, static_cast<std::size_t>(256.0 * each->normalisedIntensity(i)))];
                ++expected.total;
            }
            EXPECT_EQ(intensityHistogram(*each), expected) << each->typeName();
        }
    }
}

TEST(Histogram, LeavesOutNoDataAndNotFiniteVoxels) {
    const Volume bytes(lineOf(4), std::vector<std::uint8_t>{0, 0, 255, 128});
    const IntensityHistogram masked = intensityHistogram(bytes.withDataMask({0, 1, 1, 0}));
    EXPECT_EQ(masked.total, 2u);
    EXPECT_EQ(masked.counts[0], 1u);
    EXPECT_EQ(masked.counts[255], 1u);
    EXPECT_EQ(masked.counts[128], 0u);

    const Volume floats(lineOf(5), std::vector<float>{-3.0f, std::nanf(""), 0.5f, 2.0f, INFINITY}, 1.0);
    const IntensityHistogram clamped = intensityHistogram(floats);
    EXPECT_EQ(clamped.total, 3u);
    EXPECT_EQ(clamped.counts[0], 1u) << "below 0 counts as 0";
    EXPECT_EQ(clamped.counts[128], 1u);
    EXPECT_EQ(clamped.counts[255], 1u) << "above white counts as white";
}

}  // namespace
}  // namespace echolucent
