// echolucent-bench-render measures our ray caster beside VTK's, in one run (docs/performance.md). It needs a display
// with OpenGL.
#include <fmt/format.h>
#include <tbb/global_control.h>
#include <vtkVersion.h>

#include <CLI/CLI.hpp>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <thread>

#include "io/files/input_file.h"
#include "io/output/atomic_file.h"
#include "tests/benchmarks/render_bench.h"
#include "tests/benchmarks/render_report.h"

namespace {

using namespace echolucent;
using namespace echolucent::bench;
using nlohmann::ordered_json;

struct Options {
    BenchPlan plan;
    std::string volumeFolder = ECHOLUCENT_SOURCE_DIR "/../shared/data/volumes";
    std::string json = ECHOLUCENT_SOURCE_DIR "/build/bench/render.json";
    std::string page;
    std::string kernel;
    std::vector<std::string> parts;
};

const std::vector<std::string> allParts{"rays", "rows", "gpu", "growth", "threads", "rates"};

/// The first line of a file of /proc with that key, what stands behind the colon.
std::string procValue(const std::string& file, const std::string& key) {
    std::ifstream lines("/proc/" + file);
    for (std::string line; std::getline(lines, line);)
        if (line.rfind(key, 0) == 0) {
            const auto value = line.find_first_not_of(" \t", line.find(':') + 1);
            return value == std::string::npos ? "" : line.substr(value);
        }
    return "unknown";
}

/// The vector instructions of the processor that the kernel has routes for.
std::string vectorInstructions() {
    const std::string flags = " " + procValue("cpuinfo", "flags") + " ";
    std::string found;
    for (const char* flag : {"sse4_2", "avx2", "avx512f", "avx512vbmi"})
        if (flags.find(std::string(" ") + flag + " ") != std::string::npos) found += std::string(flag) + " ";
    if (!found.empty()) found.pop_back();
    return found;
}

std::string compiler() {
#ifdef __clang__
    return "Clang " __clang_version__;
#else
    return "GCC " __VERSION__;
#endif
}

std::string memory() {
    return fmt::format("{:.0f} GB", std::strtod(procValue("meminfo", "MemTotal").c_str(), nullptr) * 1024.0 / 1e9);
}

ordered_json machineOf(const BenchPlan& plan) {
    return {{"processor", procValue("cpuinfo", "model name")},
            {"logical cores", std::thread::hardware_concurrency()},
            {"vector instructions", vectorInstructions()},
            {"memory", memory()},
            {"compiler", compiler()},
            {"VTK", vtkVersion::GetVTKVersion()},
            {"threads", plan.threads}};
}

/// What echolucent-bench-kernel wrote: name, CPU time a sample, CPU time a picture.
Result<ordered_json> kernelRows(const std::string& path) {
    constexpr std::size_t largestFile = 1 << 22;
    const auto text = readWholeFile(path, largestFile);
    if (!text) return tl::unexpected<Failure>(text.error());
    const ordered_json file = ordered_json::parse(*text, nullptr, false);
    if (!file.is_object() || !file.contains("benchmarks"))
        return fail(FailureKind::unreadable, path, "benchmarks", "is missing: no output of Google Benchmark");
    ordered_json rows = ordered_json::array();
    for (const auto& benchmark : file["benchmarks"]) {
        std::string name = benchmark.value("name", "");
        name.resize(std::min(name.find("/process_time"), name.size()));
        ordered_json row{{"name", name}, {"cpu_ms", benchmark.value("cpu_time", 0.0)}};
        if (benchmark.contains("s_per_sample")) row["ns_per_sample"] = benchmark["s_per_sample"].get<double>() * 1e9;
        rows.push_back(std::move(row));
    }
    return rows;
}

ordered_json measured(const Options& options) {
    const BenchPlan& plan = options.plan;
    const std::set<std::string> parts(options.parts.begin(), options.parts.end());
    const auto wanted = [&](const char* part) { return parts.empty() || parts.count(part) > 0; };
    std::vector<Skipped> skipped;
    const std::vector<BenchVolume> volumes = plan.quick ? std::vector{benchPhantom(PhantomScene::shapes, {48, 44, 46})}
                                                        : benchVolumes(options.volumeFolder, skipped);
    ordered_json report;
    report["machine"] = machineOf(plan);
    report["opengl"] = "not asked for";
    report["skipped"] = ordered_json::array();
    for (const Skipped& one : skipped) {
        fmt::print(stderr, "SKIP {}: {}\n", one.volume, one.reason);
        report["skipped"].push_back({{"volume", one.volume}, {"reason", one.reason}});
    }
    if (wanted("rays")) report["registration"] = registrationOf(plan);
    if (wanted("rows")) {
        report["rows"] = renderRows(plan, volumes);
        report["summary"] = summaryOf(report["rows"]);
    }
    if (wanted("gpu")) {
        std::string openGl;
        // One phantom and one real volume say enough.
        std::vector<BenchVolume> few{volumes.front()};
        if (volumes.size() > 2) few.push_back(volumes[2]);
        report["gpu"] = gpuRows(plan, few, openGl);
        report["opengl"] = openGl;
    }
    if (wanted("growth")) report["growth"] = growthRows(plan);
    if (wanted("threads")) report["threads"] = threadRows(plan, volumes.front());
    if (wanted("rates")) {
        report["frame_rates"] = ordered_json::array();
        for (std::size_t i = 0; i < std::min<std::size_t>(volumes.size(), 2); ++i)
            for (auto& row : frameRateRows(plan, volumes[i])) report["frame_rates"].push_back(std::move(row));
    }
    return report;
}

Result<void> run(const Options& options) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(options.plan.threads));
    ordered_json report = measured(options);
    if (!options.kernel.empty()) {
        auto rows = kernelRows(options.kernel);
        if (!rows) return tl::unexpected<Failure>(rows.error());
        report["kernel"] = std::move(*rows);
    }
    const std::vector<Table> tables = tablesOf(report);
    for (const Table& table : tables)
        if (!table.rows.empty()) fmt::print("{}", asText(table));
    std::error_code none;
    std::filesystem::create_directories(std::filesystem::path(options.json).parent_path(), none);
    if (auto done = writeFileAtomically(options.json, report.dump(2) + "\n"); !done) return done;
    return options.page.empty() ? Result<void>{} : writeIntoPage(options.page, tables);
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App program("Our ray caster beside VTK's CPU and GPU mappers: time and error (docs/performance.md)");
    Options options;
    BenchPlan& plan = options.plan;
    plan.threads = static_cast<int>(tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
    plan.cacheFolder = ECHOLUCENT_SOURCE_DIR "/build/bench";
    program.add_option("--json", options.json, "Where the figures go")->capture_default_str();
    program.add_option("--markdown", options.page, "A page whose tables are replaced");
    program.add_option("--kernel", options.kernel, "Output of echolucent-bench-kernel (JSON) to take into the tables");
    program.add_option("--volumes", options.volumeFolder, "Where real volumes are looked for")->capture_default_str();
    program.add_option("--cache", plan.cacheFolder, "Where references are kept")->capture_default_str();
    program.add_option("--pictures", plan.pictureFolder, "Where ours and VTK's pictures go, side by side (PNG)");
    program.add_option("--threads", plan.threads, "Of ours and of VTK's mapper")->check(CLI::Range(1, 256));
    program.add_option("--repeats", plan.repeats, "Frames that medians are taken of")->check(CLI::Range(1, 1000));
    program.add_option("--parts", options.parts, "Some parts only")->check(CLI::IsMember(allParts))->delimiter(',');
    program.add_flag("--quick", plan.quick, "Little data, few rows: whether it works, not how fast");
    CLI11_PARSE(program, argc, argv);
    if (plan.quick) {
        plan.repeats = 1;
        plan.sizes = {96};
        plan.errorSize = 96;
    }
    const auto done = run(options);
    if (!done) fmt::print(stderr, "echolucent-bench-render: {}\n", done.error().sentence());
    return done ? 0 : 1;
}
