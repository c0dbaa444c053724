// Claims of surfaces against the truth of a simulated scan.
#include <gtest/gtest.h>

#include "app/measuring/measures/detection_quality.h"
#include "processing/adaptive/adaptive_otf.h"
#include "tests/processing/comparison/small_volumes.h"

namespace echolucent {
namespace {

/// A run of the method on the small shapes whose tubes all claim their surface `off` units behind the truth.
DetectionQuality qualityOfClaims(double off) {
    const PhantomConfig config = smallShapes();
    const PhantomTruth truth(config);
    const Volume volume = *makePhantom(config);
    AdaptiveOtfConfig method;
    method.grid.columns = method.grid.rows = 7;
    AdaptiveOtf otf = *adaptOpacity(volume, {}, method);
    const auto truths = tubeTruths(truth, volume.geometry(), {}, method);
    for (std::size_t t = 0; t < otf.tubes.size(); ++t) {
        otf.tubes[t].d = 0.01;
        if (!truths[t].interfaceDepthMm) continue;
        const Vec3 first = otf.tubes[t].firstSampleVoxel;
        const double z = (*truths[t].interfaceDepthMm + off * volume.geometry().unit()) / config.spacing[2];
        otf.tubes[t].surfaceVoxel = Vec3(first[0], first[1], z);
    }
    return detectionQuality(otf, truth, volume.geometry());
}

TEST(DetectionQuality, WhatIsClaimedAtTheTruthIsRight) {
    const DetectionQuality right = qualityOfClaims(0);
    ASSERT_GT(right.tubesWithInterface, 5);
    EXPECT_EQ(right.foundShare(), 1.0);
    EXPECT_NEAR(right.meanDistanceUnits(), 0.0, 1e-9);
    EXPECT_NEAR(right.rightShare() + right.emptyShare(), 1.0, 1e-12);
    EXPECT_GT(right.emptyShare(), 0.0);
    EXPECT_NEAR(right.rightWeight, 0.01 * right.tubesWithInterface, 1e-12);
}

TEST(DetectionQuality, ThreeUnitsAreTheBorder) {
    EXPECT_EQ(qualityOfClaims(2.99).foundShare(), 1.0);
    const DetectionQuality wrong = qualityOfClaims(3.01);
    EXPECT_EQ(wrong.tubesRight, 0);
    EXPECT_EQ(wrong.rightShare(), 0.0);
    EXPECT_NEAR(wrong.meanDistanceUnits(), 3.01, 1e-9);
}

}  // namespace
}  // namespace echolucent
