#include "tests/benchmarks/card/card_case.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "processing/phantom/phantom.h"
#include "processing/picture/camera.h"
#include "processing/viewpoint/viewpoint.h"

namespace echolucent::bench {

namespace {

std::shared_ptr<const Volume> asFloats(const Volume& volume) {
    std::vector<float> voxels;
    for (std::int64_t i = 0; i < volume.geometry().voxelCount(); ++i)
        voxels.push_back(static_cast<float>(volume.storedValue(i) - 20.0) * 3.0f);
    return std::make_shared<const Volume>(volume.geometry(), VoxelArray<float>(std::move(voxels)), 600.0);
}

/// Data in a ball, less a slanting half space, as a scalpel would leave it.
std::shared_ptr<const Volume> withHoles(const Volume& volume, bool cut) {
    const auto& size = volume.geometry().size;
    std::vector<std::uint8_t> mask;
    const Vec3 middle(0.5 * static_cast<double>(size[0]), 0.5 * static_cast<double>(size[1]),
                      0.5 * static_cast<double>(size[2]));
    for (std::int64_t z = 0; z < size[2]; ++z)
        for (std::int64_t y = 0; y < size[1]; ++y)
            for (std::int64_t x = 0; x < size[0]; ++x) {
                const Vec3 from = Vec3(static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)) - middle;
                const bool data = cut ? from.dot({0.6, 0.5, 0.62}) > -0.2 * middle[0] : length(from) < 0.8 * middle[0];
                mask.push_back(data ? 1 : 0);
            }
    if (!cut) return std::make_shared<const Volume>(volume.withDataMask(std::move(mask)));
    return std::make_shared<const Volume>(volume.withCut(std::make_shared<const DataMask>(std::move(mask))));
}

TwoDimensionalOtf walls() {
    return tabulated(64, 32, 0.15, [](double f, double g) { return std::clamp(8.0 * g * f, 0.0, 0.8); });
}

}  // namespace

std::shared_ptr<const Volume> simulated(bool fetus, int edge, int bits) {
    PhantomConfig config = defaultPhantom(fetus ? PhantomScene::fetus : PhantomScene::shapes);
    config.size = {edge, edge, edge};
    config.spacing = Vec3::all(96.0 / edge);
    config.bits = bits;
    return std::make_shared<const Volume>(*makePhantom(config));
}

Camera cameraAround(const Volume& volume, int k, int count, double aspect) {
    // Points of a golden spiral lie evenly on a sphere.
    const double height = 1.0 - 2.0 * (k + 0.5) / count, turn = k * std::numbers::pi * (3.0 - std::sqrt(5.0));
    Viewpoint view;
    view.elevationDegrees = std::asin(height) * 180.0 / std::numbers::pi;
    view.azimuthDegrees = std::remainder(turn * 180.0 / std::numbers::pi + 25.0, 360.0);
    Camera camera = defaultCamera(volume.dataBox(), view, aspect);
    if (k % 3 == 2) camera.projection = Projection::perspective;
    return camera;
}

CutSurface bowedFront(const Volume& volume, const ViewFrame& frame) {
    constexpr int nodes = 17;
    const Vec3 centre = volume.geometry().centreMm();
    const double extent = length(volume.geometry().boxMaxMm() - volume.geometry().boxMinMm());
    CutSurface surface;
    surface.frame = frame;
    surface.columns = surface.rows = nodes;
    surface.spacingMm = extent / (nodes - 1);
    surface.firstRightMm = frame.right.dot(centre) - 0.5 * extent;
    surface.firstDownMm = frame.down.dot(centre) - 0.5 * extent;
    std::vector<float> depths;
    for (int row = 0; row < nodes; ++row)
        for (int column = 0; column < nodes; ++column) {
            const double x = 2.0 * column / (nodes - 1) - 1.0, y = 2.0 * row / (nodes - 1) - 1.0;
            depths.push_back(
                static_cast<float>(frame.forward.dot(centre) + extent * (0.25 * (x * x + 0.6 * y * y) - 0.15)));
        }
    surface.depthMm = SharedList<float>(std::move(depths));
    return surface;
}

std::vector<CardCase> casesOf(const std::string& name, const std::shared_ptr<const Volume>& volume, int pixels) {
    std::vector<CardCase> cases;
    RayCastSettings plain;
    plain.width = plain.height = pixels;
    plain.step = 0.75;
    plain.terminationTransmittance = 1.0 / 128;
    RayCastSettings surface = plain;
    surface.shading = Shading{};
    RayCastSettings depth = surface;
    depth.shading->ambient = 0.5;
    depth.shading->diffuse = 1.3;
    depth.shading->reaching = ReachingLight{};
    const OpacityCurve square = PowerCurve{2, 1.0}, steep = ManualCurve{{{0.25, 0.0}, {0.4, 0.4}, {1.0, 0.9}}};
    const auto add = [&](const char* look, const Classification& otf, const RayCastSettings& settings) {
        cases.push_back({name, look, volume, otf, settings});
    };
    const VolumeGeometry& geometry = volume->geometry();
    const Vec3 centre = geometry.centreMm(), extent = geometry.boxMaxMm() - geometry.boxMinMm();
    const ViewFrame frame = frameOf(Viewpoint{BeamAxis::plusZ, 25.0, 15.0});
    add("flat", square, plain);
    add("flat, steep curve", steep, plain);
    add("surface", square, surface);
    add("surface, steep curve", steep, surface);
    add("depth", square, depth);
    add("depth, steep curve", steep, depth);
    RayCastSettings other = depth;
    other.step = 0.25;
    other.terminationTransmittance = 1.0 / 2048;
    add("depth, converged", steep, other);
    other = depth;
    other.front = CuttingFace{frame.forward, frame.forward.dot(centre) - 0.1 * extent[0]};
    add("depth, flat front", square, other);
    other = depth;
    other.cutSurface = bowedFront(*volume, frame);
    add("depth, bowed front", square, other);
    add("depth, bowed front, steep curve", steep, other);
    other = depth;
    other.box = RenderBox{centre - extent * 0.3, centre + extent.mul({0.35, 0.25, 0.4})};
    add("depth, box", square, other);
    other = surface;
    other.clippingPlanes = {{centre, {1.0, 0.5, -0.3}}, {centre + Vec3(0, 0.2 * extent[1], 0), {0.0, -2.0, 0.4}}};
    add("surface, two planes", square, other);
    other = depth;
    other.depthColouring = DepthColouring{};
    other.brightness = 1.4;
    add("depth, depth colours, brighter", square, other);
    other = plain;
    other.depthColouring = DepthColouring{};
    add("flat, depth colours", square, other);
    other = plain;
    other.interpolation = Interpolation::nearest;
    add("flat, nearest voxel", square, other);
    other = plain;
    other.mode = RenderMode::maximum;
    add("maximum", square, other);
    other.mode = RenderMode::minimum;
    add("minimum", square, other);
    other.mode = RenderMode::mean;
    add("mean", square, other);
    other = depth;
    other.mixing = {0.4, RenderMode::maximum};
    add("depth, mixed with maximum", square, other);
    add("depth, two-dimensional OTF", Classification(walls()), depth);
    other = plain;
    other.colourMap = ColourMap::ice;
    add("flat, two-dimensional OTF, ice", Classification(walls()), other);
    return cases;
}

std::vector<CardCase> casesOfPhantoms(int edge, int pixels) {
    std::vector<CardCase> cases;
    const auto take = [&](const std::string& name, const std::shared_ptr<const Volume>& volume) {
        const std::vector<CardCase> more = casesOf(name, volume, pixels);
        cases.insert(cases.end(), more.begin(), more.end());
    };
    const auto fetus = simulated(true, edge), shapes = simulated(false, edge);
    take("fetus", fetus);
    take("shapes", shapes);
    take("fetus, 12 bits", simulated(true, edge, 12));
    take("shapes, floats", asFloats(*shapes));
    take("fetus, ball of data", withHoles(*fetus, false));
    take("fetus, scalpel", withHoles(*fetus, true));
    return cases;
}

}  // namespace echolucent::bench
