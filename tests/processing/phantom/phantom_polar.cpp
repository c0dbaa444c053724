#include <gtest/gtest.h>

#include <cmath>

#include "processing/phantom/phantom.h"
#include "processing/phantom/polar_sampling.h"

namespace echolucent {
namespace {

const std::array<std::int64_t, 3> polarSize{60, 50, 40};

/// A scene without all that follows the beam or is random.
PhantomConfig plainScene(const ConversionGrid& grid) {
    PhantomConfig config = defaultPhantom(PhantomScene::shapes);
    config.speckle = config.gainVariation = 0;
    return configOnGrid(config, grid);
}

TEST(PhantomPolar, EverySampleIsTheSceneAtItsPlace) {
    for (const PolarKind kind : {PolarKind::linear, PolarKind::convex, PolarKind::linearWobbler, PolarKind::wobbler}) {
        const PolarGeometry polar = polarGeometry(usualPolar(kind, polarSize[0], 1.0), polarSize);
        const ConversionGrid grid = conversionGrid(polar);
        const PhantomConfig config = plainScene(grid);
        const PhantomTruth truth(config);
        const auto voxels = std::get<VoxelArray<std::uint8_t>>(*makePolarPhantom(config, polar, grid));
        ASSERT_EQ(voxels.size(), 60U * 50U * 40U);
        std::size_t i = 0, off = 0;
        double least = 255, most = 0;
        for (std::int64_t plane = 0; plane < polarSize[2]; ++plane)
            for (std::int64_t line = 0; line < polarSize[1]; ++line)
                for (std::int64_t sample = 0; sample < polarSize[0]; ++sample, ++i) {
                    const Vec3 mm = probeMmFromPolar(polar, {static_cast<double>(sample), static_cast<double>(line),
                                                             static_cast<double>(plane)}) -
                                    grid.geometry.origin;
                    const double echo = truth.echoAt(mm);
                    off += std::abs(voxels[i] - echo) > 0.51 ? 1 : 0;
                    least = std::min(least, echo);
                    most = std::max(most, echo);
                }
        EXPECT_EQ(off, 0U) << nameOf(kind);
        EXPECT_LT(least, 20) << nameOf(kind);
        EXPECT_GT(most, 160) << nameOf(kind);
    }
}

// Attenuation follows the samples of a beam, not the depth of the grid.
TEST(PhantomPolar, AttenuationFollowsTheBeam) {
    const PolarGeometry polar = polarGeometry(usualPolar(PolarKind::wobbler, polarSize[0], 1.0), polarSize);
    const ConversionGrid grid = conversionGrid(polar);
    PhantomConfig config = plainScene(grid);
    config.scene = PhantomScene::empty;
    config.attenuation = 0.01;
    const auto voxels = std::get<VoxelArray<std::uint8_t>>(*makePolarPhantom(config, polar, grid));
    for (std::size_t sample = 0; sample < 60; ++sample) {
        const double units = static_cast<double>(sample) / grid.geometry.spacing[0];
        const double echo = config.tissue * std::exp(-0.01 * units);
        EXPECT_NEAR(voxels[sample], echo, 0.51);
        EXPECT_EQ(voxels[sample], voxels[sample + 60 * (25 + 50 * 20)]);
    }
}

TEST(PhantomPolar, WordsAreStoredAboveEightBits) {
    const PolarGeometry polar = polarGeometry(usualPolar(PolarKind::convex, polarSize[0], 1.0), polarSize);
    const ConversionGrid grid = conversionGrid(polar);
    PhantomConfig config = plainScene(grid);
    config.bits = 12;
    const auto voxels = std::get<VoxelArray<std::uint16_t>>(*makePolarPhantom(config, polar, grid));
    EXPECT_GT(*std::max_element(voxels.begin(), voxels.end()), 2000);
}

TEST(PhantomPolar, CancelledRunGivesNothing) {
    const PolarGeometry polar = polarGeometry(usualPolar(PolarKind::convex, polarSize[0], 1.0), polarSize);
    const ConversionGrid grid = conversionGrid(polar);
    const std::atomic<bool> cancel = true;
    Progress progress;
    progress.cancel = &cancel;
    EXPECT_FALSE(makePolarPhantom(plainScene(grid), polar, grid, progress));
}

}  // namespace
}  // namespace echolucent
