// What is left out: the render box, clipping planes, the near plane, and what stands behind something opaque.
#include <gtest/gtest.h>

#include <cmath>

#include "ray_caster_scenes.h"

namespace echolucent {
namespace {

const OpacityCurve haze = PowerCurve{2, 0.3};

std::shared_ptr<const DepthMap> depthMap(int width, int height, std::vector<float> depths) {
    return std::make_shared<const DepthMap>(DepthMap{width, height, std::move(depths)});
}

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
    const auto opaque = [&](Settings& s) {
        std::vector<float> depths;
        for (int i = 0; i < 7 * 5; ++i)
            depths.push_back(i % 4 == 0 ? INFINITY : static_cast<float>(middle + i % 9 - 4.3));
        s.opaqueDepth = depthMap(7, 5, depths);
    };
    const auto near = [&](Settings& s) { s.nearPlaneDepthMm = middle - 3.7; };
    add("box", box);
    add("planes", planes);
    add("opaque", opaque);
    add("near plane", near);
    add("box that reaches beyond the volume", [](Settings& s) {
        s.box = RenderBox{{-50, 5.2, -1e9}, {1e9, 900, 8.8}};
    });
    add("all", [&](Settings& s) { box(s), planes(s), opaque(s), near(s); });
    return cuts;
}

template <typename Voxel>
void expectCutsLikeTheReference() {
    const Volume whole = randomVolume<Voxel>({19, 17, 21}, {1, 0.9, 1.1}, 41);
    for (const Volume& volume : {whole, sectorOf(whole)})
        for (const Viewpoint& view :
             {Viewpoint{}, Viewpoint{BeamAxis::minusY, 0, 0, 0, 0}, Viewpoint{BeamAxis::plusX, 33, -24, 5, 0}})
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
        for (const Viewpoint& view : {Viewpoint{}, Viewpoint{BeamAxis::plusX, 33, -24, 5, 0}})
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
    for (const Viewpoint& view : {Viewpoint{}, Viewpoint{BeamAxis::plusX, 33, -24, 5, 0}})
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

TEST(RayCasterCuts, ASlabEndsAtTheOpaqueDepthExactly) {
    const Volume volume = constantVolume<std::uint8_t>({20, 20, 40}, 0.5);
    const float start = -0.5f;  // the slab's face, mm
    for (const double step : {0.25, 1.0, 3.0})
        for (const float depth : {0.0f, 0.6f, 7.3f, 31.9f, 39.4f, 400.0f}) {
            RayCastSettings settings = settingsFor(volume, Viewpoint{}, 8, 8);
            settings.camera.heightMm = 16;
            settings.step = step;
            settings.opaqueDepth = depthMap(1, 1, {start + depth});
            const double alpha = -std::expm1(std::clamp(static_cast<double>(depth), 0.0, 40.0) * std::log1p(-0.02));
            const auto picture = castRays(volume, everywhere(0.02), settings);
            for (std::size_t i = 3; i < picture->rgba.size(); i += 4)
                ASSERT_NEAR(picture->rgba[i], alpha, 1e-6) << depth << " mm, step " << step;
        }
}

TEST(RayCasterCuts, ADepthMapOfAnotherSizeIsReadAtTheNearestPlace) {
    const Volume volume = constantVolume<std::uint8_t>({20, 20, 40}, 0.5);
    RayCastSettings settings = settingsFor(volume, Viewpoint{}, 12, 10);
    settings.camera.heightMm = 15;
    const std::vector<float> depths{4.5f, 9.5f, 14.5f, 19.5f, 24.5f, 29.5f};
    settings.opaqueDepth = depthMap(3, 2, depths);
    const auto picture = castRays(volume, everywhere(0.02), settings);
    for (int row = 0; row < 10; ++row)
        for (int column = 0; column < 12; ++column) {
            const float depth = depths[static_cast<std::size_t>(row / 5 * 3 + column / 4)];
            ASSERT_NEAR(pixelAt(*picture, column, row)[3], 1 - std::pow(0.98, static_cast<double>(depth) + 0.5), 1e-6)
                << column << "," << row;
        }
    std::vector<float> fine(60 * 50);
    for (std::size_t i = 0; i < fine.size(); ++i) fine[i] = depths[i / 60 / 25 * 3 + i % 60 / 20];
    settings.opaqueDepth = depthMap(60, 50, fine);
    EXPECT_TRUE(castRays(volume, everywhere(0.02), settings)->rgba == picture->rgba) << "a larger one";
}

TEST(RayCasterCuts, NothingOpaqueAndAllHidden) {
    const Volume volume = randomVolume<std::uint16_t>({20, 21, 22}, {1, 1, 1}, 9);
    for (const Projection projection : {Projection::parallel, Projection::perspective})
        for (const RenderMode mode : {RenderMode::direct, RenderMode::maximum, RenderMode::mean}) {
            RayCastSettings settings = settingsFor(volume, Viewpoint{BeamAxis::plusX, 33, -24, 5, 0}, 30, 30);
            settings.camera.projection = projection;
            settings.mode = mode;
            const auto whole = castRays(volume, haze, settings);
            settings.opaqueDepth = depthMap(1, 1, {INFINITY});
            EXPECT_TRUE(castRays(volume, haze, settings)->rgba == whole->rgba);
            settings.opaqueDepth = depthMap(1, 1, {std::nanf("")});
            EXPECT_TRUE(castRays(volume, haze, settings)->rgba == whole->rgba) << "not a number: nothing stands there";
            for (const float before : {-1e9f, -INFINITY, -40.0f}) {
                settings.opaqueDepth = depthMap(1, 1, {before});
                EXPECT_EQ(largestAlpha(*castRays(volume, haze, settings)), 0.0f) << before;
            }
        }
}

/// The ray through a pixel, by the definition of the camera.
struct Line {
    Vec3 from, direction;
};
Line lineThrough(const RayCastSettings& settings, int column, int row) {
    const Camera& camera = settings.camera;
    const bool parallel = camera.projection == Projection::parallel;
    const double height =
        parallel ? camera.heightMm : 2 * std::tan(camera.viewAngleDegrees / 2 * std::numbers::pi / 180);
    const Vec3 across = camera.frame.right * ((column + 0.5 - settings.width / 2.0) * height / settings.height) +
                        camera.frame.down * ((row + 0.5 - settings.height / 2.0) * height / settings.height);
    if (parallel) return {camera.focalPoint + across - camera.frame.forward * 1e3, camera.frame.forward};
    return {camera.focalPoint - camera.frame.forward * camera.distanceMm, normalized(camera.frame.forward + across)};
}

/// Where a line is in a sphere, or in a box, as distances along it; it is empty where the line is in neither.
std::pair<double, double> inSphere(const Line& line, const Vec3& centre, double radius) {
    const Vec3 from = line.from - centre;
    const double b = from.dot(line.direction), c = from.dot(from) - radius * radius;
    if (b * b < c) return {INFINITY, -INFINITY};
    return {-b - std::sqrt(b * b - c), -b + std::sqrt(b * b - c)};
}
std::pair<double, double> inBox(const Line& line, const Vec3& low, const Vec3& high) {
    double first = -INFINITY, last = INFINITY;
    for (int axis = 0; axis < 3; ++axis) {
        const double a = (low[axis] - line.from[axis]) / line.direction[axis],
                     b = (high[axis] - line.from[axis]) / line.direction[axis];
        first = std::max(first, std::min(a, b));
        last = std::min(last, std::max(a, b));
    }
    return {first, last};
}

// Half of the sphere stands out of one face. From each side every pixel shows as much of the volume as is before the
// sphere.
TEST(RayCasterCuts, AnOpaqueSphereHalfInsideTheVolumeIsRightFromSixSides) {
    const Volume volume = constantVolume<std::uint8_t>({50, 44, 40}, 0.6, {1, 1.1, 0.9});
    const Vec3 low = volume.geometry().boxMinMm(), high = volume.geometry().boxMaxMm();
    const Vec3 centre{volume.geometry().centreMm()[0] + 4.0, volume.geometry().centreMm()[1] - 3.0, low[2]};
    constexpr double radius = 13.0, opacity = 0.03;
    for (int beam = 0; beam < 6; ++beam)
        for (const double azimuth : {0.7, 24.0})
            for (const Projection projection : {Projection::parallel, Projection::perspective}) {
                Viewpoint view;
                view.beamAxis = static_cast<BeamAxis>(beam);
                view.azimuthDegrees = azimuth;
                view.elevationDegrees = 0.4;
                RayCastSettings settings = settingsFor(volume, view, 72, 64);
                settings.nearPlaneDepthMm = -INFINITY;
                settings.camera.heightMm *= 1.3;
                settings.camera.distanceMm *= 1.4;
                settings.camera.projection = projection;
                settings.step = 0.25;
                const double stepMm = 0.25 * volume.geometry().unit();
                DepthMap map{72, 64, {}};
                for (int row = 0; row < 64; ++row)
                    for (int column = 0; column < 72; ++column) {
                        const Line line = lineThrough(settings, column, row);
                        const double there = inSphere(line, centre, radius).first;
                        const Vec3 point = line.from + line.direction * (std::isfinite(there) ? there : 0.0);
                        map.depthMm.push_back(std::isfinite(there)
                                                  ? static_cast<float>(settings.camera.frame.forward.dot(point))
                                                  : INFINITY);
                    }
                settings.opaqueDepth = std::make_shared<const DepthMap>(map);
                const auto picture = castRays(volume, everywhere(opacity), settings);
                int before = 0, within = 0, behind = 0;
                for (int row = 0; row < 64; ++row)
                    for (int column = 0; column < 72; ++column) {
                        const Line line = lineThrough(settings, column, row);
                        const auto [first, last] = inBox(line, low, high);
                        const double sphere = inSphere(line, centre, radius).first;
                        const double path = std::max(0.0, std::min(last, sphere) - first) / volume.geometry().unit();
                        const float* pixel = pixelAt(*picture, column, row);
                        // Samples are counted: the path may be a step longer or shorter.
                        ASSERT_NEAR(pixel[3], 1 - std::pow(1 - opacity, path),
                                    1.01 * opacity * stepMm / volume.geometry().unit())
                            << "side " << beam << ", " << column << "," << row;
                        const bool hidden = sphere <= first && first < last;
                        ASSERT_TRUE(!hidden || pixel[3] == 0.0f) << "the sphere hides the volume";
                        before += hidden ? 1 : 0;
                        within += first < sphere && sphere < last ? 1 : 0;
                        behind += first < last && sphere == INFINITY ? 1 : 0;
                    }
                EXPECT_GT(behind, 500);
                EXPECT_GT(before + within, 60) << "the sphere is seen";
            }
}

}  // namespace
}  // namespace echolucent
