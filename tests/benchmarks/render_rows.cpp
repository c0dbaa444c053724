// Ours beside VTK's CPU mapper, picture by picture.
#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <opencv2/core/saturate.hpp>

#include "io/writers/picture_file.h"
#include "processing/ray_caster/ray_caster.h"
#include "tests/benchmarks/render_bench.h"
#include "tests/benchmarks/row_parts.h"
#include "tests/benchmarks/side_by_side.h"

namespace echolucent::bench {

namespace {

using nlohmann::ordered_json;

/// A shaded reference takes seven times the samples, and every second pixel of every second row tells as much.
constexpr int shadedStride = 2;

struct Errors {
    PictureError ours, vtk;
    std::optional<RayCoarseness> coarsest;  ///< of ours with an error that is not larger than VTK's; unshaded only
};

/// Ours stands on the left, VTK's on the right.
void writeSideBySide(const BenchPlan& plan, const std::string& name, const std::vector<float>& ours,
                     const std::vector<float>& vtk) {
    if (plan.pictureFolder.empty()) return;
    const auto line = static_cast<std::size_t>(plan.errorSize) * 3;
    std::vector<std::uint8_t> bytes;
    for (std::size_t row = 0; row < ours.size(); row += line)
        for (const std::vector<float>* picture : {&ours, &vtk})
            for (std::size_t i = row; i < row + line; ++i)
                bytes.push_back(cv::saturate_cast<std::uint8_t>(255.0f * (*picture)[i]));
    std::error_code none;
    std::filesystem::create_directories(plan.pictureFolder, none);
    const std::string path = (std::filesystem::path(plan.pictureFolder) / (name + ".png")).string();
    if (const auto done = writePng(path, 2 * plan.errorSize, plan.errorSize, bytes); !done)
        fmt::print(stderr, "{}\n", done.error().sentence());
}

/// Unshaded, both are compared to the double reference. Shaded, only ours is; VTK, which lights in another way, is
/// compared to itself at the reference's step.
Errors errorsOf(const BenchPlan& plan, const BenchVolume& volume, const NamedCurve& named, bool shaded) {
    const OpacityCurve& curve = named.curve;
    RayCastSettings settings = turnedSettings(volume, lookOf(shaded), plan.errorSize, 0.0);
    const ReferencePicture reference =
        cachedReference(plan.cacheFolder, *volume.volume, curve, settings, shaded ? shadedStride : 1);
    Errors errors;
    const std::vector<float> ours = rgbOf(*castRays(*volume.volume, curve, settings));
    errors.ours = errorOf(ours, reference, settings);
    VtkScene scene(VtkScene::Renderer::fixedPoint, *volume.volume, plan.errorSize, plan.threads);
    scene.setLook(curve, settings, shaded);
    scene.draw(settings);
    const std::vector<float> vtk = scene.rgb();
    writeSideBySide(plan, volume.name + (shaded ? ", shaded, " : ", ") + named.name, ours, vtk);
    if (!shaded) {
        errors.vtk = errorOf(vtk, reference, settings);
        errors.coarsest = coarsestWithin(errors.vtk.rmse, *volume.volume, curve, settings, reference);
        return errors;
    }
    settings.step = referenceStep;
    scene.draw(settings);
    errors.vtk = differenceOf(vtk, scene.rgb(), shadedStride, settings);
    return errors;
}

ordered_json rowOf(const BenchVolume& volume, const NamedCurve& curve, const RayCastSettings& look,
                   const SideBySide& costs, const Errors& errors) {
    ordered_json row{{"volume", volume.name}, {"otf", curve.name}, {"size", 0}, {"shaded", look.shading.has_value()}};
    addCost(row, "ours", costs.ours);
    addCost(row, "vtk", costs.vtkRays);
    addRatios(row, costs.ours, costs.vtkRays);
    addError(row, "ours", errors.ours);
    addError(row, "vtk", errors.vtk);
    row["repeats"] = costs.repeats;
    addCost(row, "ours_first", costs.oursFirst);
    if (volume.masked) addCost(row, "ours_masked", costs.oursMasked);
    if (look.shading) addCost(row, "ours_reaching", costs.oursReaching);
    if (errors.coarsest) {
        addCost(row, "ours_coarse", costs.oursCoarse);
        row["coarse_cpu_ratio"] = costs.vtkRays.cpuMs / costs.oursCoarse.cpuMs;
        row["coarse_reduction"] = errors.coarsest->reduction;
        row["coarse_step"] = errors.coarsest->step;
        row["coarse_rmse"] = errors.coarsest->rmse;
    }
    addCost(row, "vtk_set_up", costs.vtkSetUp);
    addCost(row, "vtk_frame", costs.vtkFrame);
    addCost(row, "vtk_first", costs.vtkFirst);
    return row;
}

/// All pictures of one volume.
class VolumeRows {
public:
    VolumeRows(const BenchPlan& plan, const BenchVolume& volume)
        : m_plan(plan), m_volume(volume), m_curves(benchCurves(volume)), m_ours(volume.volume) {
        if (plan.quick) m_curves.erase(m_curves.begin());
        if (volume.masked) m_masked.emplace(volume.masked);
    }

    void addTo(ordered_json& rows) {
        for (const int size : m_plan.sizes) {
            VtkScene vtk(VtkScene::Renderer::fixedPoint, *m_volume.volume, size, m_plan.threads);
            for (const bool shaded : {false, true})
                for (const NamedCurve& curve : m_curves) rows.push_back(measured(vtk, size, curve, shaded));
        }
    }

private:
    ordered_json measured(VtkScene& vtk, int size, const NamedCurve& curve, bool shaded) {
        const RayCastSettings look = lookOf(shaded);
        vtk.setLook(curve.curve, look, shaded);
        const Errors& errors = errorsFor(curve, shaded);
        const Contenders contenders{m_volume, *m_ours.caster, m_masked ? &*m_masked : nullptr, vtk, errors.coarsest};
        const SideBySide costs = measureSideBySide(contenders, curve.curve, look, size, m_plan.repeats);
        ordered_json row = rowOf(m_volume, curve, look, costs, errors);
        row["size"] = size;
        row["error_size"] = m_plan.errorSize;
        addCost(row, "ours_prepare", m_ours.cost);
        fmt::print(stderr, "{}, {}, {} pixels{}: {:.1f} ms, {:.1f} ms, {:.1f} times less CPU\n", m_volume.name,
                   curve.name, size, shaded ? ", shaded" : "", costs.ours.cpuMs, costs.vtkRays.cpuMs,
                   row["cpu_ratio"].get<double>());
        return row;
    }
    /// Each ray is by itself, so the error is measured once, in pictures of one size.
    const Errors& errorsFor(const NamedCurve& curve, bool shaded) {
        const std::pair key(curve.name, shaded);
        auto found = m_errors.find(key);
        if (found == m_errors.end()) found = m_errors.emplace(key, errorsOf(m_plan, m_volume, curve, shaded)).first;
        return found->second;
    }

    const BenchPlan& m_plan;
    const BenchVolume& m_volume;
    std::vector<NamedCurve> m_curves;
    PreparedCaster m_ours;
    std::optional<RayCaster> m_masked;
    std::map<std::pair<std::string, bool>, Errors> m_errors;
};

}  // namespace

ordered_json renderRows(const BenchPlan& plan, const std::vector<BenchVolume>& volumes) {
    ordered_json rows = ordered_json::array();
    for (const BenchVolume& volume : volumes) VolumeRows(plan, volume).addTo(rows);
    return rows;
}

}  // namespace echolucent::bench
