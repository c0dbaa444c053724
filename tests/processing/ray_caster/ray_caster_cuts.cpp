// What is left out: the render box, clipping planes and the near plane.
#include <gtest/gtest.h>

#include <cmath>

#include "ray_caster_scenes.h"

namespace echolucent {
namespace {

const OpacityCurve haze = PowerCurve{2, 0.3};

/// Cuts of every kind, alone and together.
std::vector<std::pair<std::string, RayCastSettings>> cutsOf(const RayCastSettings& plain,
                                                            const VolumeGeometry& geometry) {
    std::vector<std::pair<std::string, RayCastSettings>> cuts;
    const auto add = [&](const std::string& name, const auto& change) {
        cuts.emplace_back(name, plain);
        change(cuts.back().second);
    };
    using Settings = RayCastSettings;
    const Vec3 centre = geometry.centreMm();
    const double middle = plain.camera.frame.forward.dot(centre);
    const auto box = [](Settings& s) { s.box = RenderBox{{3.3, 2.1, 4.7}, {16.2, 14.9, 13.3}}; };
    const auto planes = [&](Settings& s) {
        s.clippingPlanes = {{centre + Vec3(1, 0, 2), {1, 0.7, -0.4}},
                            {centre - Vec3(0, 4, 0), {0, 1e-7, 2e-8}},
                            {centre, {-3e6, 1e6, 4e6}}};
    };
    const auto near = [&](Settings& s) { s.front = CuttingFace{s.camera.frame.forward, middle - 3.7}; };
    add("box", box);
    add("planes", planes);
    add("near plane", near);
    add("box that reaches beyond the volume", [](Settings& s) {
        s.box = RenderBox{{-50, 5.2, -1e9}, {1e9, 900, 8.8}};
    });
    add("all", [&](Settings& s) { box(s), planes(s), near(s); });
    return cuts;
}

template <typename Voxel>
void expectCutsLikeTheReference() {
    const Volume whole = randomVolume<Voxel>({19, 17, 21}, {1, 0.9, 1.1}, 41);
    for (const Volume& volume : {whole, sectorOf(whole)})
        for (const Viewpoint& view :
             {Viewpoint{}, Viewpoint{BeamAxis::minusY, 0, 0, 0}, Viewpoint{BeamAxis::plusX, 33, -24, 5}})
            for (const Projection projection : {Projection::parallel, Projection::perspective}) {
                RayCastSettings plain = settingsFor(volume, view, 35, 25);
                plain.camera.projection = projection;
                plain.step = 0.63;
                for (auto& [name, settings] : cutsOf(plain, volume.geometry())) {
                    EXPECT_LT(largestDifference(volume, haze, settings), 2 * noiseTolerance(volume, false)) << name;
                    settings.shading = Shading{};
                    // A sample may be worth a gradient, or just not: 1/128 of its pixel.
                    EXPECT_LT(largestDifference(volume, haze, settings), std::max(0.01, noiseTolerance(volume, true)))
                        << name << ", shaded";
                }
            }
}
TEST(RayCasterCuts, BytesAreCutAsTheReferenceSays) { expectCutsLikeTheReference<std::uint8_t>(); }
TEST(RayCasterCuts, WordsAreCutAsTheReferenceSays) { expectCutsLikeTheReference<std::uint16_t>(); }
TEST(RayCasterCuts, FloatsAreCutAsTheReferenceSays) { expectCutsLikeTheReference<float>(); }

TEST(RayCasterCuts, ABoxThatLeavesNothingShowsNothing) {
    const Volume volume = constantVolume<std::uint8_t>({20, 20, 20}, 1.0);
    const RenderBox boxes[] = {{{25, 0, 0}, {90, 20, 20}},     {{0, -90, 0}, {20, -30, 20}},
                               {{0, 0, 1e6}, {20, 20, 2e6}},   {{12, 0, 0}, {8, 20, 20}},
                               {{5, 5, 5}, {5, 5, 5}},         {{0, 0, 1e9}, {20, 20, -1e9}},
                               {{-90, -90, -90}, {-1, -1, -1}}};
    for (const RenderBox& box : boxes)
        for (const Viewpoint& view : {Viewpoint{}, Viewpoint{BeamAxis::plusX, 33, -24, 5}})
            for (const Projection projection : {Projection::parallel, Projection::perspective})
                for (const RenderMode mode : {RenderMode::direct, RenderMode::maximum, RenderMode::mean}) {
                    RayCastSettings settings = settingsFor(volume, view, 40, 40);
                    settings.camera.projection = projection;
                    settings.camera.heightMm *= 4;
                    settings.box = box;
                    settings.mode = mode;
                    EXPECT_EQ(largestAlpha(*castRays(volume, everywhere(1.0), settings)), 0.0f)
                        << box.low[0] << " " << box.low[1] << " " << box.low[2];
                }
}

TEST(RayCasterCuts, PlanesThatLeaveNothingShowNothingAndPlanesBesideChangeNothing) {
    const Volume volume = randomVolume<std::uint8_t>({20, 20, 20}, {1, 1, 1}, 3);
    for (const Viewpoint& view : {Viewpoint{}, Viewpoint{BeamAxis::plusX, 33, -24, 5}})
        for (const Projection projection : {Projection::parallel, Projection::perspective}) {
            RayCastSettings settings = settingsFor(volume, view, 40, 40);
            settings.camera.projection = projection;
            const auto whole = castRays(volume, haze, settings);
            // The planes face each other, lie across the rays, along them, and askew.
            for (const Vec3& normal : {settings.camera.frame.forward, settings.camera.frame.right, Vec3(1, 2, -3)}) {
                settings.clippingPlanes = {{Vec3(11, 11, 11), normal}, {Vec3(10, 10, 10), normal * -1.0}};
                const bool apartOnes = normal.dot(Vec3(1, 1, 1)) > 0.0;
                if (!apartOnes) std::swap(settings.clippingPlanes[0].point, settings.clippingPlanes[1].point);
                EXPECT_EQ(largestAlpha(*castRays(volume, haze, settings)), 0.0f);
                settings.clippingPlanes = {{Vec3(10, 10, 10) - normal * 100.0, normal}};
                EXPECT_TRUE(castRays(volume, haze, settings)->rgba == whole->rgba)
                    << "all of the volume is on its side";
                settings.clippingPlanes = {{Vec3(10, 10, 10) + normal * 100.0, normal}};
                EXPECT_EQ(largestAlpha(*castRays(volume, haze, settings)), 0.0f);
            }
        }
}

TEST(RayCasterCuts, ASlabEndsAtAPlaneExactly) {
    const Volume volume = constantVolume<std::uint8_t>({20, 20, 40}, 0.5);
    const double start = -0.5;  // the slab's face, mm
    for (const double step : {0.25, 1.0, 3.0})
        for (const double depth : {0.0, 0.6, 7.3, 31.9, 39.4, 400.0}) {
            RayCastSettings settings = settingsFor(volume, Viewpoint{}, 8, 8);
            settings.camera.heightMm = 16;
            settings.step = step;
            settings.clippingPlanes = {{{0, 0, start + depth}, {0, 0, -1}}};
            const double alpha = -std::expm1(std::clamp(depth, 0.0, 40.0) * std::log1p(-0.02));
            const auto picture = castRays(volume, everywhere(0.02), settings);
            for (std::size_t i = 3; i < picture->rgba.size(); i += 4)
                ASSERT_NEAR(picture->rgba[i], alpha, 1e-6) << depth << " mm, step " << step;
        }
}

}  // namespace
}  // namespace echolucent
