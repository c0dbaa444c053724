// This measures ours beside VTK's GPU mapper, as volumes grow and as threads grow, with one curve, unshaded but for the
// GPU.
#include <fmt/format.h>
#include <tbb/global_control.h>

#include <cstdio>
#include <nlohmann/json.hpp>

#include "processing/ray_caster/ray_caster.h"
#include "tests/benchmarks/render_bench.h"
#include "tests/benchmarks/row_parts.h"
#include "tests/benchmarks/side_by_side.h"

namespace echolucent::bench {

namespace {

using nlohmann::ordered_json;

constexpr int gpuRepeats = 3;

ordered_json gpuRow(const BenchPlan& plan, const BenchVolume& volume, RayCaster& ours, bool shaded,
                    std::string& openGl) {
    const NamedCurve curve = parabolicCurve();
    const int size = plan.errorSize;
    VtkScene gpu(VtkScene::Renderer::gpu, *volume.volume, size, plan.threads);
    gpu.setLook(curve.curve, lookOf(shaded), shaded);
    const SideBySide costs = measureSideBySide({volume, ours, nullptr, gpu}, curve.curve, lookOf(shaded), size,
                                               std::min(plan.repeats, gpuRepeats));
    ordered_json row{{"volume", volume.name}, {"otf", curve.name}, {"size", size}, {"shaded", shaded}};
    addCost(row, "ours", costs.ours);
    addCost(row, "gpu", costs.vtkFrame);
    addRatios(row, costs.ours, costs.vtkFrame);
    if (!shaded) {
        const RayCastSettings settings = turnedSettings(volume, lookOf(false), size, 0.0);
        gpu.draw(settings);
        addError(
            row, "gpu",
            errorOf(gpu.rgb(), cachedReference(plan.cacheFolder, *volume.volume, curve.curve, settings, 1), settings));
    }
    openGl = gpu.openGlRenderer();
    fmt::print(stderr, "GPU mapper, {}{}: {:.1f} ms, {:.1f} ms wall\n", volume.name, shaded ? ", shaded" : "",
               costs.ours.wallMs, costs.vtkFrame.wallMs);
    return row;
}

/// Ours beside VTK's CPU mapper with the parabolic curve, unshaded, on that many threads.
ordered_json plainRow(const BenchPlan& plan, const BenchVolume& volume, int threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
    const NamedCurve curve = parabolicCurve();
    PreparedCaster ours(volume.volume);
    VtkScene vtk(VtkScene::Renderer::fixedPoint, *volume.volume, plan.errorSize, threads);
    vtk.setLook(curve.curve, lookOf(false), false);
    const SideBySide costs = measureSideBySide({volume, *ours.caster, nullptr, vtk}, curve.curve, lookOf(false),
                                               plan.errorSize, plan.repeats);
    ordered_json row{{"volume", volume.name}, {"otf", curve.name}, {"size", plan.errorSize}, {"threads", threads}};
    addCost(row, "ours", costs.ours);
    addCost(row, "vtk", costs.vtkRays);
    addRatios(row, costs.ours, costs.vtkRays);
    addCost(row, "ours_prepare", ours.cost);
    addCost(row, "ours_first", costs.oursFirst);
    addCost(row, "vtk_first", costs.vtkFirst);
    return row;
}

}  // namespace

ordered_json gpuRows(const BenchPlan& plan, const std::vector<BenchVolume>& volumes, std::string& openGl) {
    ordered_json rows = ordered_json::array();
    for (const BenchVolume& volume : volumes) {
        RayCaster ours(volume.volume);
        rows.push_back(gpuRow(plan, volume, ours, false, openGl));
        if (!plan.quick) rows.push_back(gpuRow(plan, volume, ours, true, openGl));
    }
    return rows;
}

ordered_json growthRows(const BenchPlan& plan) {
    // The largest is made from the one before: a phantom of its own takes minutes.
    constexpr int largestMade = 256;
    ordered_json rows = ordered_json::array();
    BenchVolume volume;
    for (const int edge : plan.quick ? std::vector{32, 64} : std::vector{64, 128, 256, 512}) {
        const bool resampled = edge > largestMade;
        volume = resampled ? doubled(volume) : benchPhantom(PhantomScene::shapes, {edge, edge, edge});
        ordered_json row = plainRow(plan, volume, plan.threads);
        row["voxels"] = edge;
        row["resampled"] = resampled;
        fmt::print(stderr, "{} cubed: {:.1f} ms, {:.1f} ms\n", edge, row["ours_cpu_ms"].get<double>(),
                   row["vtk_cpu_ms"].get<double>());
        rows.push_back(std::move(row));
    }
    return rows;
}

ordered_json threadRows(const BenchPlan& plan, const BenchVolume& volume) {
    ordered_json rows = ordered_json::array();
    for (int threads = 1; threads < plan.threads; threads *= 2) rows.push_back(plainRow(plan, volume, threads));
    rows.push_back(plainRow(plan, volume, plan.threads));
    return rows;
}

}  // namespace echolucent::bench
