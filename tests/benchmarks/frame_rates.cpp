// This measures ours alone: how many pictures a second it makes, at which error.
#include <fmt/format.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "processing/adaptive/adaptive_otf.h"
#include "processing/ray_caster/ray_caster.h"
#include "tests/benchmarks/render_bench.h"
#include "tests/benchmarks/row_parts.h"
#include "tests/benchmarks/side_by_side.h"
#include "widgets/casting/qualities.h"

namespace echolucent::bench {

namespace {

using nlohmann::ordered_json;

/// The finest qualities of the program, as many as are measured.
constexpr std::size_t measuredOfTheProgram = 8;

/// The program's finest qualities from fine to coarse, and one between the first two that the program does not have.
std::array<Quality, measuredOfTheProgram + 1> measuredQualities() {
    std::array<Quality, measuredOfTheProgram + 1> measured{};
    measured[0] = qualities[0];
    measured[1] = {"between", 1.0, 0.5, false, 1.0 / 512};
    std::copy_n(qualities.begin() + 1, measuredOfTheProgram - 1, measured.begin() + 2);
    return measured;
}

/// Frame rates are promised for two cores, whatever the machine has.
constexpr int threadsOfRates = 2;
constexpr int referencePixels = 512;

class RatesOfCurve {
public:
    RatesOfCurve(const BenchPlan& plan, const BenchVolume& volume, const NamedCurve& curve)
        : m_plan(plan), m_volume(volume), m_curve(curve), m_caster(volume.volume) {}

    void addTo(ordered_json& rows) {
        for (const int size : m_plan.sizes) {
            const int stride = std::max(1, size / referencePixels);
            const RayCastSettings window = turnedSettings(m_volume, lookOf(false), size, 0.0);
            const ReferencePicture reference =
                cachedReference(m_plan.cacheFolder, *m_volume.volume, m_curve.curve, window, stride);
            for (const Quality& quality : measuredQualities())
                rows.push_back(qualityRow(quality, size, window, reference));
            rows.push_back(editRow(size));
        }
    }

private:
    [[nodiscard]] int repeats() const { return m_plan.quick ? 1 : 2 * m_plan.repeats + 1; }
    [[nodiscard]] ordered_json rowOf(const char* what, int size, const std::vector<Cost>& costs) const {
        ordered_json row{{"what", what}, {"volume", m_volume.name}, {"otf", m_curve.name}, {"size", size}};
        const Cost cost = medianOf(costs);
        addCost(row, "ours", cost);
        row["frames_per_second"] = 1000.0 / cost.wallMs;
        return row;
    }

    ordered_json qualityRow(const Quality& quality, int size, const RayCastSettings& window,
                            const ReferencePicture& reference) {
        const int pixels = static_cast<int>(std::lround(size / quality.reduction));
        RayCastSettings look;
        look.step = quality.step;
        look.terminationTransmittance = quality.terminationTransmittance;
        const auto turned = [&](int frame) {
            return turnedSettings(m_volume, look, pixels, turnBetweenFrames * frame);
        };
        const auto picture = m_caster.cast(m_curve.curve, turned(0));
        std::vector<Cost> costs;
        for (int i = 1; i <= repeats(); ++i)
            costs.push_back(costOf([&] { (void)m_caster.cast(m_curve.curve, turned(i)); }));
        ordered_json row = rowOf("quality", size, costs);
        row["reduction"] = quality.reduction;
        row["step"] = quality.step;
        row["ends_at"] = quality.terminationTransmittance;
        addError(row, "ours", errorOf(pixels == size ? rgbOf(*picture) : enlarged(*picture, size), reference, window));
        return row;
    }

    /// Each time another curve is shown, under one camera.
    ordered_json editRow(int size) {
        const RayCastSettings settings = turnedSettings(m_volume, lookOf(false), size, 0.0);
        const std::vector<double> opacities = sampledOpacities(m_curve.curve, AdaptiveOtf::sampleCount);
        int edits = 0;
        const auto edit = [&] {
            SampledCurve curve{opacities};
            ++edits;
            for (double& opacity : curve.opacities) opacity *= 1.0 - 0.01 * edits;
            return costOf([&] { (void)m_caster.cast(curve, settings); });
        };
        const Cost whole = edit(), firstEdit = edit();
        std::vector<Cost> costs;
        for (int i = 0; i < repeats(); ++i) costs.push_back(edit());
        ordered_json row = rowOf("edit", size, costs);
        addCost(row, "before_edits", whole);
        addCost(row, "first_edit", firstEdit);
        row["kept_bytes"] = m_caster.keptSampleBytes();
        return row;
    }

    const BenchPlan& m_plan;
    const BenchVolume& m_volume;
    const NamedCurve& m_curve;
    RayCaster m_caster;
};

}  // namespace

ordered_json frameRateRows(const BenchPlan& plan, const BenchVolume& volume) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threadsOfRates);
    ordered_json rows = ordered_json::array();
    for (const NamedCurve& curve : benchCurves(volume)) {
        if (curve.name == "linear") continue;
        RatesOfCurve(plan, volume, curve).addTo(rows);
        fmt::print(stderr, "frame rates, {}, {}\n", volume.name, curve.name);
    }
    return rows;
}

}  // namespace echolucent::bench
