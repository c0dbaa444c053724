// A curve that shows nothing of the data says so.
#include "processing/picture/empty_picture.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace echolucent {
namespace {

/// Voxels of these intensities, ten each.
IntensityHistogram dataOf(std::initializer_list<double> intensities) {
    IntensityHistogram histogram;
    for (const double intensity : intensities) {
        histogram.counts[static_cast<std::size_t>(intensity * 255.999)] += 10;
        histogram.total += 10;
    }
    return histogram;
}

TEST(EmptyPicture, ACurveThatIsZeroOverTheDataShowsNothing) {
    const IntensityHistogram data = dataOf({0.1, 0.3, 0.5});
    const LinearCurve beyond{0.6, 0.5, 1.0}, within{0.45, 0.5, 1.0};
    EXPECT_TRUE(showsNothing(beyond, data));
    EXPECT_FALSE(showsNothing(within, data));
    EXPECT_TRUE(showsNothing(ManualCurve{}, data));
    EXPECT_TRUE(showsNothing(SampledCurve{}, data));
    EXPECT_FALSE(showsNothing(PowerCurve{}, data));
    EXPECT_TRUE(showsNothing(PowerCurve{}, dataOf({0.0}))) << "a volume of a wrong white level is black";
}

TEST(EmptyPicture, BetweenTwoVoxelsSamplesTakeWhatLiesBetween) {
    const ManualCurve needle{{{0.3, 0.0}, {0.30001, 0.8}, {0.30002, 0.0}}};
    EXPECT_FALSE(showsNothing(needle, dataOf({0.1, 0.5})));
    EXPECT_TRUE(showsNothing(needle, dataOf({0.1, 0.2})));
    EXPECT_TRUE(showsNothing(needle, dataOf({0.4, 0.5})));
}

TEST(EmptyPicture, TheSentenceSaysWhatToDo) {
    EXPECT_EQ(whyNothingShows(PowerCurve{}, dataOf({0.1, 0.5})), "");
    EXPECT_EQ(whyNothingShows(LinearCurve{0.6, 0.5, 1.0}, dataOf({0.0, 0.5})),
              "Nothing is shown: the curve is 0 over all intensities of the data (0.000 to 0.500). Let it rise below "
              "0.500, or choose another curve.");
    EXPECT_THAT(whyNothingShows(PowerCurve{}, IntensityHistogram{}), testing::HasSubstr("no voxel of the volume"));
}

}  // namespace
}  // namespace echolucent
