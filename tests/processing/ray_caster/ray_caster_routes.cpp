// Plain pictures go another way through the kernel than those with light or depth: both show the same.
#include <gtest/gtest.h>

#include "ray_caster_scenes.h"

namespace echolucent {
namespace {

/// The pictures are made with depth asked for, and without.
void expectSameOnBothRoutes(const Volume& volume, const OpacityCurve& curve, RayCastSettings settings, double levels,
                            const std::string& what) {
    settings.findDepth = false;
    const auto plain = castRays(volume, curve, settings);
    settings.findDepth = true;
    const Apart difference = apart(*plain, *castRays(volume, curve, settings));
    EXPECT_LT(difference.largest, levels) << what;
    EXPECT_GT(largestAlpha(*plain), 0.05f) << what;
}

template <typename Voxel>
void expectRoutesAgree() {
    const Volume whole = speckledShell<Voxel>({41, 37, 45}, {1, 1.2, 0.8}, 5);
    for (const Volume& volume : {whole, sectorOf(whole)})
        for (const Projection projection : {Projection::parallel, Projection::perspective})
            for (const double end : {0.0, 1.0 / 128, 0.2})
                for (const OpacityCurve& curve :
                     {OpacityCurve{PowerCurve{1, 0.9}}, everywhere(0.3), onlyBetween(0.4, 0.9, 0.5)}) {
                    RayCastSettings settings = obliqueSettings(volume, 61, 53);
                    settings.camera.projection = projection;
                    settings.terminationTransmittance = end;
                    // Positions differ in their last bit; of bytes that may be a step in their shares of 7 bits.
                    expectSameOnBothRoutes(
                        volume, curve, settings, std::is_same_v<Voxel, std::uint8_t> ? 1.0 : 0.1,
                        "ends at " + std::to_string(end) + ", curve " + std::to_string(curve.index()));
                }
}
TEST(RayCasterRoutes, BytesAreShownAlikeOnBoth) { expectRoutesAgree<std::uint8_t>(); }
TEST(RayCasterRoutes, WordsAreShownAlikeOnBoth) { expectRoutesAgree<std::uint16_t>(); }
TEST(RayCasterRoutes, FloatsAreShownAlikeOnBoth) { expectRoutesAgree<float>(); }

TEST(RayCasterRoutes, ARayThatHasEndedGetsNothingOfTheBackFace) {
    // On the left the volume is opaque early on. On the right there is, for some rays of the same packet, nothing but
    // the outermost half voxel, which all rays leave through.
    const Volume volume = volumeOf<std::uint8_t>({16, 16, 40}, {1, 1, 1}, [](auto x, auto, auto z) {
        return z == 39 ? 1.0 : x < 6 && z > 5 && z < 9 ? 0.5 : 0.0;
    });
    RayCastSettings settings = settingsFor(volume, Viewpoint{}, 16, 16);
    settings.camera.heightMm = 16;
    settings.step = 0.9;  // the last four ninths of a step are cut off
    settings.interpolation = Interpolation::nearest;
    settings.terminationTransmittance = 0.2;
    const auto picture = castRays(volume, ManualCurve{{{0.0, 0.0}, {0.4, 0.0}, {0.5, 0.45}, {1.0, 0.6}}}, settings);
    for (int row = 0; row < 16; ++row)
        for (int column = 0; column < 16; ++column) {
            const float alpha = pixelAt(*picture, column, row)[3];
            // There are three samples of the block, one of the last voxel, and the cut step.
            EXPECT_NEAR(alpha, 1.0 - (column < 6 ? std::pow(0.55, 3 * 0.9) : std::pow(0.4, 0.9 + 0.4)), 1e-3) << column;
        }
}

TEST(RayCasterRoutes, BytesAboveWhiteAreWhiteAlsoWhereSamplesAreKept) {
    for (const double white : {255.0, 200.0, 128.0, 100.0, 1.0}) {
        VolumeGeometry geometry;
        geometry.size = {20, 20, 20};
        std::vector<std::uint8_t> voxels(8000);
        std::mt19937 dice(8);
        for (auto& voxel : voxels) voxel = static_cast<std::uint8_t>(dice() % 3 == 0 ? 255 : dice() % 120);
        const Volume volume = sectorOf(Volume(geometry, std::move(voxels), white));
        RayCastSettings settings = obliqueSettings(volume, 31, 29);
        RayCaster caster(held(volume));
        for (int picture = 0; picture < 3; ++picture) (void)caster.cast(PowerCurve{1, 0.5}, settings);
        EXPECT_GT(caster.keptSampleBytes(), 0u);
        for (const bool tinted : {false, true}) {
            if (tinted) settings.depthColouring = DepthColouring{};
            const auto kept = caster.cast(PowerCurve{1, 0.3}, settings);
            const Apart difference = apart(*kept, *castRays(volume, PowerCurve{1, 0.3}, settings));
            EXPECT_LT(difference.rootMeanSquare, 0.2) << white;
            EXPECT_LT(difference.largest, 3.0) << white << (tinted ? " tinted" : "");
            EXPECT_LT(largestDifference(*kept, volume, PowerCurve{1, 0.3}, settings), tinted ? 1.0 : 0.05) << white;
        }
    }
}

TEST(RayCasterRoutes, CutStepsOfOnePacketMayLieFarApart) {
    const Volume volume = volumeOf<std::uint8_t>({6, 6, 40000}, {1, 1, 1}, [](auto, auto, auto) { return 0.5; });
    for (const bool withDepth : {false, true})
        for (const RenderMode mode : {RenderMode::direct, RenderMode::mean}) {
            RayCastSettings settings = settingsFor(volume, Viewpoint{}, 6, 6);
            settings.camera.heightMm = 6;
            settings.step = 0.7;
            settings.mode = mode;
            settings.findDepth = withDepth;
            constexpr double perColumn = 9000.0;  // voxels
            settings.clippingPlanes = {{{0, 0, 5.1}, {perColumn, 0, -1}}};
            const auto picture = castRays(volume, everywhere(1e-5), settings);
            for (int i = 0; i < 36; ++i) {
                const double length = std::min(5.6 + perColumn * (i % 6), 40000.0);
                const double expected = mode == RenderMode::mean ? 1.0 : -std::expm1(length * std::log1p(-1e-5));
                EXPECT_NEAR(pixelAt(*picture, i % 6, i / 6)[3], expected, 1e-5) << i;
            }
        }
}

}  // namespace
}  // namespace echolucent
