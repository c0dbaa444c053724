// Whether a scan begins with a face that is almost white, and what is done about it.
#include "processing/near_cut/bright_face.h"

#include <gtest/gtest.h>

#include "processing/document/opening_finds.h"
#include "tests/processing/grids.h"

namespace echolucent {
namespace {

/// Layers along z: 12 voxels of `face`, then 20 of fluid, then tissue.
Volume layers(std::uint8_t face) {
    const VolumeGeometry geometry = gridOf({24, 24, 64});
    std::vector<std::uint8_t> voxels;
    for (std::int64_t z = 0; z < geometry.size[2]; ++z)
        voxels.insert(voxels.end(), 24 * 24, z < 12 ? face : static_cast<std::uint8_t>(z < 32 ? 5 : 90));
    return Volume(geometry, std::move(voxels), 255.0);
}

TEST(BrightFace, IsWhatRaysEndIn) {
    // Of even tissue a ray shows its intensity, apart from what 12 units let through, and from the last step's fade.
    for (const int face : {150, 204, 240}) {
        const double intensity = face / 255.0;
        EXPECT_NEAR(faceIntensity(layers(static_cast<std::uint8_t>(face)), Viewpoint{}).value(), intensity, 0.02)
            << face;
    }
    EXPECT_NEAR(faceIntensity(layers(240), withFrontAcross({}, 14.0)).value(), 90 / 255.0, 0.05) << "behind a cut";
    EXPECT_EQ(faceIntensity(layers(240), withFrontAcross({}, 64.0)).value(), 0.0) << "nothing is left";
    Viewpoint bowed;
    bowed.cutSurface = CutSurface{
        .frame = frameOf(bowed), .spacingMm = 30, .columns = 2, .rows = 2, .depthMm = {14.F, 15.F, 16.F, 17.F}};
    EXPECT_NEAR(faceIntensity(layers(240), bowed).value(), 90 / 255.0, 0.05) << "behind a bowed front";
}

TEST(BrightFace, TakesNoLongerForVoxelsThatAreFlat) {
    // 24 x 24 x 8000 voxels whose smallest spacing is a thousandth of the others: rays of eight million units.
    VolumeGeometry geometry = gridOf({24, 24, 8000}, {0.001, 1, 1});
    const Volume even(geometry, std::vector<std::uint8_t>(static_cast<std::size_t>(geometry.voxelCount()), 0), 255.0);
    EXPECT_EQ(faceIntensity(even, Viewpoint{}).value(), 0.0);
    const std::atomic<bool> cancelled{true};
    EXPECT_FALSE(faceIntensity(even, Viewpoint{}, {{}, &cancelled}));
}

TEST(BrightFace, OnlyAFaceThatIsAlmostWhiteIsShownDarker) {
    EXPECT_EQ(exposureFor(0.0), 1.0);
    EXPECT_EQ(exposureFor(mostFaceIntensity), 1.0);
    EXPECT_DOUBLE_EQ(exposureFor(0.9) * 0.9, calmFaceIntensity);
}

/// A bright wall before a ball of tissue in fluid, or even bright tissue.
Volume whiteScan(bool opens) {
    const VolumeGeometry geometry = gridOf({64, 64, 64});
    std::vector<std::uint8_t> voxels;
    for (int z = 0; z < 64; ++z)
        for (int y = 0; y < 64; ++y)
            for (int x = 0; x < 64; ++x) {
                const bool inFluid = opens && z >= 12 && z < 44;
                voxels.push_back(static_cast<std::uint8_t>(inFluid ? 5 : z < 12 || !opens ? 250 : 120));
            }
    return Volume(geometry, std::move(voxels), 255.0);
}

TEST(BrightFace, OpeningDarkensAFaceThatStaysAndNoFaceThatIsCutAway) {
    const SaidOnOpening said{.beam = BeamAxis::plusZ};
    const auto calm = findOnOpening(layers(150), {}, said), stays = findOnOpening(whiteScan(false), {}, said),
               goes = findOnOpening(whiteScan(true), {}, said);
    ASSERT_TRUE(calm && stays && goes);
    EXPECT_EQ(withFinds({}, *calm).scene.exposure, 1.0);
    ASSERT_FALSE(makesFront(*stays->cut));
    EXPECT_NEAR(withFinds({}, *stays).scene.exposure, calmFaceIntensity / (250 / 255.0), 0.01);
    ASSERT_TRUE(makesFront(*goes->cut)) << goes->cut->message;
    EXPECT_EQ(withFinds({}, *goes).scene.exposure, 1.0);
}

TEST(BrightFace, ALookOnlyMultipliesTheExposure) {
    Document document;
    document.scene.look.brightness = 1.5;
    document = withFinds(document, *findOnOpening(whiteScan(false), {}, {.beam = BeamAxis::plusZ}));
    EXPECT_LT(document.scene.exposure, 0.7);
    EXPECT_EQ(document.scene.look.brightness, 1.5);
    EXPECT_DOUBLE_EQ(shownLook(document.scene).brightness, 1.5 * document.scene.exposure);
    EXPECT_EQ(findOnOpening(whiteScan(false), {}, {.beam = BeamAxis::plusZ, .front = true})->exposure, 1.0)
        << "who chooses a front sees to the rest";
    EXPECT_EQ(openedDocument(document, {}).scene.exposure, 1.0) << "the next study has its own";
}

}  // namespace
}  // namespace echolucent
