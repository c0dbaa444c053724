// The curve for quiet voxels: surfaces of the volume, intensities and speckle of the voxels that are shown.
#include "processing/adaptive/quiet_reading.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <stdexcept>

#include "processing/adaptive/adaptive_otf.h"
#include "processing/adaptive/method_reading.h"
#include "processing/phantom/phantom.h"

namespace echolucent {
namespace {

const Volume& shapes() {
    static const Volume volume = [] {
        PhantomConfig config = defaultPhantom(PhantomScene::shapes);
        config.size = {110, 100, 120};
        config.seed = 5;
        return *makePhantom(config);
    }();
    return volume;
}

const Volume& quietShapes() {
    static const Volume volume = *quietVolume(shapes(), SpeckleReduction::medium);
    return volume;
}

TEST(QuietReading, WithAllSpeckleLeftTheRuleIsTheRule) {
    const RampRule ramp;
    EXPECT_EQ(quieterRule(ramp, 1.0), CurveRule(ramp));
    const auto quieter = std::get<RampRule>(quieterRule(ramp, 0.25));
    EXPECT_GT(quieter.begin, ramp.begin);
    EXPECT_LT(quieter.end, ramp.end);
    EXPECT_GE(std::get<RampRule>(quieterRule(RampRule{.begin = 1.0, .end = 1.05}, 0.0)).end, 1.1);
    EXPECT_EQ(quieterRule(ProductRule{}, 0.25), CurveRule(ProductRule{}));
}

TEST(QuietReading, SurfacesAreThoseOfTheVolumeAndTheCurveIsNot) {
    const AdaptiveOtfConfig meanRamps = configOf(MethodReading::firstVersion);
    const AdaptiveOtf raw = *adaptOpacity(shapes(), {}, meanRamps);
    const AdaptiveOtf quiet = *adaptOpacity(shapes(), {}, meanRamps, {}, {&quietShapes(), SpeckleReduction::medium});
    EXPECT_EQ(raw.reduction, SpeckleReduction::off);
    EXPECT_EQ(raw.speckleLeft, 1.0);
    EXPECT_EQ(quiet.reduction, SpeckleReduction::medium);
    EXPECT_LT(quiet.speckleLeft.value(), 0.5);
    EXPECT_GT(quiet.speckleLeft.value(), 0.0);
    ASSERT_EQ(raw.tubes.size(), quiet.tubes.size());
    for (std::size_t t = 0; t < raw.tubes.size(); ++t) {
        EXPECT_EQ(raw.tubes[t].surfaceVoxel, quiet.tubes[t].surfaceVoxel);
        EXPECT_EQ(raw.tubes[t].lowIntensity, quiet.tubes[t].lowIntensity);
        EXPECT_EQ(raw.tubes[t].d, quiet.tubes[t].d);
    }
    // Halfway between fluid and tissue, where speckle used to be, it is clearer.
    EXPECT_LT(quiet.curve.opacities[45], raw.curve.opacities[45]);
}

TEST(QuietReading, ClaimsNoSpeckleLeftIfNoneWasMeasured) {
    const QuietVoxels shown{&quietShapes(), SpeckleReduction::medium};
    const AdaptiveOtf byVariance = *adaptOpacity(shapes(), {}, configOf(MethodReading::asPublished), {}, shown);
    EXPECT_FALSE(byVariance.quiet.empty());
    EXPECT_FALSE(byVariance.speckleLeft);
    const Volume even(shapes().geometry(),
                      std::vector<std::uint8_t>(static_cast<std::size_t>(shapes().geometry().voxelCount()), 90));
    EXPECT_FALSE(adaptOpacity(even, {}, {}, {}, {&even, SpeckleReduction::medium})->speckleLeft);
    EXPECT_EQ(adaptOpacity(even, {}, {})->speckleLeft, 1.0);
}

TEST(QuietReading, OnTheVoxelsThatWereReadItIsTheCurveThatWasRead) {
    const AdaptiveOtf raw = *adaptOpacity(shapes(), {}, {});
    const AdaptiveOtf same = *adaptOpacity(shapes(), {}, {}, {}, {&shapes(), SpeckleReduction::light});
    EXPECT_EQ(same.speckleLeft, 1.0);
    EXPECT_EQ(same.curve.opacities, raw.curve.opacities);
}

TEST(QuietReading, HasDataWhereTheVoxelsThatWereReadHaveThem) {
    const auto voxels = static_cast<std::size_t>(shapes().geometry().voxelCount());
    const Volume blind = quietShapes().withDataMask(std::vector<std::uint8_t>(voxels, 0));
    const AdaptiveOtf seeing = *adaptOpacity(shapes(), {}, {}, {}, {&quietShapes(), SpeckleReduction::medium});
    const AdaptiveOtf masked = *adaptOpacity(shapes(), {}, {}, {}, {&blind, SpeckleReduction::medium});
    ASSERT_GT(seeing.tubesWithWeight, 0);
    EXPECT_EQ(masked.curve.opacities, seeing.curve.opacities);
}

TEST(QuietReading, HasTheSameBitsForAnyNumberOfThreads) {
    std::vector<std::vector<double>> curves;
    for (const std::size_t threads : {1, 4}) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        curves.push_back(
            adaptOpacity(shapes(), {}, {}, {}, {&quietShapes(), SpeckleReduction::medium})->curve.opacities);
    }
    EXPECT_EQ(curves[0], curves[1]);
}

TEST(QuietReading, RefusesAnotherGrid) {
    const Volume other(VolumeGeometry{}, std::vector<std::uint8_t>(1));
    EXPECT_THROW((void)adaptOpacity(shapes(), {}, {}, {}, {&other, SpeckleReduction::light}), std::invalid_argument);
}

}  // namespace
}  // namespace echolucent
