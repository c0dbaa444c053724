// The proof that both renderers cast the same rays.
#include <cmath>
#include <nlohmann/json.hpp>

#include "processing/ray_caster/ray_caster.h"
#include "tests/benchmarks/plain_reference.h"
#include "tests/benchmarks/render_bench.h"
#include "tests/benchmarks/side_by_side.h"

namespace echolucent::bench {

namespace {

using nlohmann::ordered_json;

/// The step is one unit, as all comparisons have it.
RayCastSettings plainLook() { return {}; }

/// One bright voxel off the centre of an empty grid: its picture's centroid is known to a hundredth of a pixel.
BenchVolume oneVoxel() {
    VolumeGeometry geometry;
    geometry.size = {33, 29, 31};
    std::vector<std::uint8_t> voxels(static_cast<std::size_t>(geometry.voxelCount()), 0);
    voxels[static_cast<std::size_t>(geometry.offset(11, 19, 8))] = 255;
    Viewpoint view;
    view.azimuthDegrees = 20.0;
    view.elevationDegrees = -12.0;
    return {"one voxel", std::make_shared<const Volume>(geometry, std::move(voxels), 255.0), nullptr, view};
}

struct Place {
    double column, row;
};

Place centroidOf(const std::vector<float>& rgb, int size) {
    double sum = 0.0, columns = 0.0, rows = 0.0;
    for (int row = 0; row < size; ++row)
        for (int column = 0; column < size; ++column) {
            const double value = static_cast<double>(rgb[static_cast<std::size_t>((row * size + column) * 3)]);
            sum += value;
            columns += value * column;
            rows += value * row;
        }
    return {columns / sum, rows / sum};
}

/// Where a grid place appears in the picture, pixels.
Place projected(const RayCastSettings& settings, const Vec3& gridMm) {
    const Vec3 offset = gridMm - settings.camera.focalPoint;
    const double pixelMm = settings.camera.heightMm / settings.height;
    return {offset.dot(settings.camera.frame.right) / pixelMm + settings.width * 0.5 - 0.5,
            offset.dot(settings.camera.frame.down) / pixelMm + settings.height * 0.5 - 0.5};
}

double distance(const Place& a, const Place& b) { return std::hypot(a.column - b.column, a.row - b.row); }

/// Across the picture, the place where both renderers, and the GPU mapper, see one voxel is compared with where it is.
ordered_json pixelOffsets(const BenchPlan& plan) {
    const BenchVolume volume = oneVoxel();
    const OpacityCurve curve = PowerCurve{1, 0.5};
    RayCastSettings settings = turnedSettings(volume, plainLook(), plan.errorSize, 0.0);
    settings.step = 0.25;  // of so small a thing, samples at whole voxels say too little
    const Place expected = projected(settings, {11, 19, 8});
    const Place ours = centroidOf(rgbOf(*castRays(*volume.volume, curve, settings)), plan.errorSize);
    ordered_json offsets;
    offsets["ours_pixel_offset"] = distance(ours, expected);
    for (const auto renderer : {VtkScene::Renderer::fixedPoint, VtkScene::Renderer::gpu}) {
        VtkScene scene(renderer, *volume.volume, plan.errorSize, plan.threads);
        scene.setLook(curve, settings, false);
        scene.draw(settings);
        const bool cpu = renderer == VtkScene::Renderer::fixedPoint;
        offsets[cpu ? "vtk_pixel_offset" : "gpu_pixel_offset"] =
            distance(centroidOf(scene.rgb(), plan.errorSize), expected);
    }
    return offsets;
}

BenchVolume smallPhantom(const BenchPlan& plan) {
    const int edge = plan.quick ? 48 : 96;
    return benchPhantom(PhantomScene::shapes, {edge, edge, edge});
}

/// Along the rays, at a step of two units the picture of speckle depends on where samples lie. Of VTK's pictures with
/// its sample planes moved by shares of a step, the one on our planes must be the nearest to ours.
ordered_json depthOffsets(const BenchPlan& plan) {
    const BenchVolume volume = smallPhantom(plan);
    const OpacityCurve curve = parabolicCurve().curve;
    RayCastSettings settings = turnedSettings(volume, plainLook(), plan.errorSize, 0.0);
    settings.step = 2.0;
    const std::vector<float> ours = rgbOf(*castRays(*volume.volume, curve, settings));
    VtkScene scene(VtkScene::Renderer::fixedPoint, *volume.volume, plan.errorSize, plan.threads);
    scene.setLook(curve, settings, false);
    ordered_json differences = ordered_json::array();
    for (const double shift : {-0.5, -0.25, 0.0, 0.25, 0.5}) {
        scene.draw(settings, shift);
        differences.push_back({{"shift_steps", shift}, {"rmse", differenceOf(scene.rgb(), ours, 1, settings).rmse}});
    }
    return differences;
}

/// At the reference's own step only the arithmetic is left to differ.
void addConverged(ordered_json& registration, const BenchPlan& plan) {
    const BenchVolume volume = smallPhantom(plan);
    const OpacityCurve curve = parabolicCurve().curve;
    RayCastSettings settings = turnedSettings(volume, plainLook(), plan.errorSize, 0.0);
    const ReferencePicture reference = cachedReference(plan.cacheFolder, *volume.volume, curve, settings, 1);
    settings.step = referenceStep;
    registration["ours_rmse_at_reference_step"] =
        errorOf(rgbOf(*castRays(*volume.volume, curve, settings)), reference, settings).rmse;
    VtkScene scene(VtkScene::Renderer::fixedPoint, *volume.volume, plan.errorSize, plan.threads);
    scene.setLook(curve, settings, false);
    scene.draw(settings);
    registration["vtk_rmse_at_reference_step"] = errorOf(scene.rgb(), reference, settings).rmse;
}

}  // namespace

ordered_json registrationOf(const BenchPlan& plan) {
    ordered_json registration = pixelOffsets(plan);
    registration["ours_to_vtk_by_depth_shift"] = depthOffsets(plan);
    addConverged(registration, plan);
    return registration;
}

}  // namespace echolucent::bench
