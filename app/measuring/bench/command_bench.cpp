#include "app/measuring/bench/command_bench.h"

#include <fmt/format.h>
#include <tbb/global_control.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <functional>
#include <nlohmann/json.hpp>
#include <span>
#include <string>

#include "app/measuring/run_time.h"
#include "app/measuring/study.h"
#include "io/output/atomic_file.h"
#include "processing/adaptive/adaptive_otf.h"
#include "processing/median.h"
#include "processing/motion/otf_sweep.h"
#include "processing/phantom/phantom.h"

namespace echolucent::cli {

namespace {

using nlohmann::ordered_json;

struct BenchOptions {
    VolumeOptions volume;
    ViewOptions view;
    MethodOptions method;
    std::string json;
    int runs = 51;
};

/// The oblique view if no option gives another, degrees.
constexpr double defaultAzimuth = 20.0, defaultElevation = -12.0;
/// Runs before any counts: they fill caches and page tables.
constexpr int warmUps = 3;

double leastOf(const std::vector<double>& values) { return *std::min_element(values.begin(), values.end()); }

constexpr std::array<std::pair<const char*, double StageTimes::*>, 5> stages{{{"sampling", &StageTimes::sampling},
                                                                              {"cells", &StageTimes::cells},
                                                                              {"detection", &StageTimes::detection},
                                                                              {"weights", &StageTimes::weights},
                                                                              {"curve", &StageTimes::curve}}};

/// The runs of one view, side by side with those of Touch.
class ViewBench {
public:
    ViewBench(const Volume& volume, const Viewpoint& view, const AdaptiveOtfConfig& config)
        : m_volume(volume), m_view(view), m_config(config), m_touch(volume, view, config) {}

    void run(bool counts) {
        // Run each once untimed, because the other one has filled the caches.
        auto otf = adaptOpacity(m_volume, m_view, m_config);
        const double total = millisecondsOf([&] { otf = adaptOpacity(m_volume, m_view, m_config); });
        m_sink = m_sink + m_touch.run();
        const double touch = millisecondsOf([&] { m_sink = m_sink + m_touch.run(); });
        if (!counts) return;
        m_total.push_back(total);
        m_touchTimes.push_back(touch);
        for (std::size_t i = 0; i < stages.size(); ++i) m_stages[i].push_back(otf->times.*stages[i].second);
    }

    [[nodiscard]] ordered_json report() const {
        ordered_json report;
        const double total = medianOf(m_total), touch = medianOf(m_touchTimes);
        report["azimuth"] = m_view.azimuthDegrees;
        report["elevation"] = m_view.elevationDegrees;
        report["total_ms"] = total;
        report["touch_ms"] = touch;
        report["least_total_ms"] = leastOf(m_total);
        report["least_touch_ms"] = leastOf(m_touchTimes);
        report["times_touch"] = total / touch;
        for (std::size_t i = 0; i < stages.size(); ++i) report["stages_ms"][stages[i].first] = medianOf(m_stages[i]);
        return report;
    }

private:
    const Volume& m_volume;
    Viewpoint m_view;
    const AdaptiveOtfConfig& m_config;
    Touch m_touch;
    volatile double m_sink = 0.0;
    std::vector<double> m_total, m_touchTimes;
    std::array<std::vector<double>, stages.size()> m_stages;
};

constexpr int sweepViews = 91;
constexpr double sweepFrom = -45.0, sweepTo = 45.0;

/// Seconds for the OTFs of a probe that turns about the screen's vertical.
double sweepSeconds(const std::shared_ptr<const Volume>& volume, const Viewpoint& start,
                    const AdaptiveOtfConfig& config) {
    const auto frames = sweepFrames(start, MotionAxis::screenVertical, sweepFrom, sweepTo, 1.0, 1);
    return millisecondsOf([&] { (void)sweepOtfs(std::span(&volume, 1), frames, config, OtfSmoothing::none); }) / 1000.0;
}

std::string tableOf(const ordered_json& report) {
    std::string table = fmt::format("{:<28}{:>12}{:>12}\n", "median ms, one thread", "axis view", "oblique");
    const auto row = [&](const std::string& name, const std::function<double(const ordered_json&)>& value, int digits) {
        table += fmt::format("{:<28}{:>12.{}f}{:>12.{}f}\n", name, value(report["axis"]), digits,
                             value(report["oblique"]), digits);
    };
    for (const auto& stage : stages)
        row(
            stage.first, [&](const ordered_json& view) { return view["stages_ms"][stage.first].get<double>(); }, 3);
    for (const auto& [name, key] : {std::pair{"total", "total_ms"},
                                    {"touching the voxels", "touch_ms"},
                                    {"least total", "least_total_ms"},
                                    {"least touching", "least_touch_ms"}})
        row(
            name, [&, k = key](const ordered_json& view) { return view[k].get<double>(); }, 3);
    row(
        "total / touching", [](const ordered_json& view) { return view["times_touch"].get<double>(); }, 2);
    table += fmt::format("sweep of {} views, {} thread(s): {:.3f} s\n", report["sweep_views"].get<int>(),
                         report["threads"].get<int>(), report["sweep_s"].get<double>());
    return table;
}

Result<std::shared_ptr<const Volume>> volumeOf(const BenchOptions& options) {
    if (!options.volume.path.empty()) return options.volume.readPhase({options.json});
    return std::make_shared<const Volume>(*makePhantom(defaultPhantom(PhantomScene::shapes)));
}

Result<void> bench(const BenchOptions& options) {
    if (auto checked = checkOutputs({options.json}, {options.method.initial}); !checked) return checked;
    if (const auto checked = options.view.get(); !checked) return tl::unexpected<Failure>(checked.error());
    const auto config = options.method.get();
    if (!config) return tl::unexpected<Failure>(config.error());
    const auto volume = volumeOf(options);
    if (!volume) return tl::unexpected<Failure>(volume.error());
    const auto view =
        options.view.get(**volume, options.volume.path.empty() ? options.view.beam() : options.view.beamOf(**volume));
    if (!view) return tl::unexpected<Failure>(view.error());

    Viewpoint axis = *view, oblique = *view;
    axis.azimuthDegrees = axis.elevationDegrees = 0.0;
    if (oblique == axis) {
        oblique.azimuthDegrees = defaultAzimuth;
        oblique.elevationDegrees = defaultElevation;
    }
    ordered_json report;
    const auto& size = (*volume)->geometry().size;
    report["volume"] = {{"size", {size[0], size[1], size[2]}}, {"type", (*volume)->typeName()}};
    report["tube_grid"] = {config->grid.columns, config->grid.rows};
    report["runs"] = options.runs;
    {
        const tbb::global_control oneThread(tbb::global_control::max_allowed_parallelism, 1);
        ViewBench axisBench(**volume, axis, *config), obliqueBench(**volume, oblique, *config);
        for (int i = -warmUps; i < options.runs; ++i)
            for (ViewBench* side : {&axisBench, &obliqueBench}) side->run(i >= 0);
        report["axis"] = axisBench.report();
        report["oblique"] = obliqueBench.report();
    }
    report["threads"] = tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
    report["sweep_views"] = sweepViews;
    std::vector<double> sweeps(5);
    for (double& seconds : sweeps) seconds = sweepSeconds(*volume, axis, *config);
    report["sweep_s"] = medianOf(sweeps);

    if (!options.json.empty())
        if (auto done = writeFileAtomically(options.json, report.dump(2) + "\n"); !done) return done;
    if (options.json == "-") return {};
    return writeFileAtomically("-", tableOf(report));
}

}  // namespace

void addBenchCommand(CLI::App& program, Action& action) {
    auto options = std::make_shared<BenchOptions>();
    CLI::App& command = *program.add_subcommand("bench", "Measures how fast a stage is");
    command.require_subcommand(1);
    CLI::App& otf =
        *command.add_subcommand("otf", "Times the adaptive OTF beside touching its voxels (docs/cli-bench.md)");
    options->volume.addTo(otf);
    otf.get_option("VOLUME")->required(false);
    options->view.addTo(otf);
    options->method.addTo(otf);
    otf.add_option("--runs,--repeats", options->runs, "Runs of which the median is taken")
        ->check(CLI::Range(1, 100000))
        ->capture_default_str();
    otf.add_option("--json", options->json, "The figures as JSON; - is standard output")->type_name("FILE");
    command.footer("Example: echolucent-cli bench otf --threads 2 --json bench.json");
    otf.footer("Example: echolucent-cli bench otf chest.mha --beam-axis +y --near 18");
    otf.callback([options, &action] { action = [options] { return bench(*options); }; });
}

}  // namespace echolucent::cli
