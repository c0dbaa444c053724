// What large studies cost: memory and time of `info`, and of reading in one process and by a reader process.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "io/restricted/restricted_reader.h"
#include "process_memory.h"
#include "tests/io/written_files/temporary_folder.h"

namespace {

using namespace echolucent;
using bench::watch;
using bench::WatchedRun;

struct Options {
    int edge = 512, phases = 20, phaseEdge = 256, runs = 3;
    std::string one;                 // how the child reads: "here" or "reader"
    std::vector<std::string> files;  // in place of those made here
    bool watches = false;            // a program with its arguments stands in place of the files
    double seconds = 1e9;            // of the program
};

/// Reads in the way asked for, which the parent watches.
int readOne(const Options& options) {
    const std::string& path = options.files.front();
    const auto study = options.one == "here" ? readStudy(path) : restricted::readStudy(path);
    if (!study) fmt::print(stderr, "{}\n", study.error().sentence());
    return study ? 0 : 1;
}

/// A sector in water: what no rule of any reader takes for empty, with an outside that is guessed.
void writeSector(const std::string& path, int edge, int phases) {
    std::ofstream file(path, std::ios::binary);
    file << fmt::format(
        "NRRD0004\ntype: uchar\ndimension: 4\nsizes: {} {} {} {}\nkinds: domain domain domain time\n"
        "spacings: 0.3 0.3 0.3 0.05\nencoding: raw\n\n",
        edge, edge, edge, phases);
    std::vector<char> row(static_cast<std::size_t>(edge));
    std::uint32_t random = 1;
    for (int phase = 0; phase < phases; ++phase)
        for (int z = 0; z < edge; ++z)
            for (int y = 0; y < edge; ++y) {
                for (int x = 0; x < edge; ++x) {
                    random = random * 1664525U + 1013904223U;
                    const bool inside = std::abs(2 * x - edge) + std::abs(2 * y - edge) < edge / 4 + z;
                    row[static_cast<std::size_t>(x)] = inside ? static_cast<char>(1 + (random >> 25)) : '\0';
                }
                file.write(row.data(), edge);
            }
}

/// The run of the median time, with the largest peak of all.
WatchedRun measured(const std::vector<std::string>& command, int runs) {
    std::vector<WatchedRun> all;
    for (int run = 0; run < runs; ++run) all.push_back(watch(command));
    std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.seconds < b.seconds; });
    WatchedRun result = all[all.size() / 2];
    for (const WatchedRun& run : all) {
        result.peakMebibytes = std::max(result.peakMebibytes, run.peakMebibytes);
        result.succeeded = result.succeeded && run.succeeded;
    }
    return result;
}

/// Prints the rows of one file. False where one of its runs failed.
bool measure(const std::string& self, const std::string& path, const std::string& folder, int runs) {
    const double mebibytes = static_cast<double>(std::filesystem::file_size(path)) / (1 << 20);
    const std::string info = (std::filesystem::path(self).parent_path() / "echolucent-cli").string();
    const std::array<std::pair<const char*, std::vector<std::string>>, 3> ways{
        {{"read in this process", {self, "--one", "here", path}},
         {"read by a reader process", {self, "--one", "reader", path}},
         {"echolucent-cli info --json", {info, "info", path, "--json", folder + "/info.json"}}}};
    bool all = true;
    for (const auto& [name, command] : ways) {
        const WatchedRun run = measured(command, runs);
        fmt::print("| {} | {} | {:.2f} | {:.0f} | {:.2f} |\n", std::filesystem::path(path).filename().string(), name,
                   run.seconds, run.peakMebibytes, run.peakMebibytes / mebibytes);
        all = all && run.succeeded;
    }
    return all;
}

}  // namespace

int main(int argc, char** argv) {
    Options options;
    CLI::App program{"Memory and time that large studies take, all processes together"};
    program.add_option("FILE", options.files, "Volumes as they are stored, in place of those made here");
    program.add_option("--edge", options.edge, "Voxels along each edge of the single volume")->capture_default_str();
    program.add_option("--phases", options.phases, "Phases of the other")->capture_default_str();
    program.add_option("--phase-edge", options.phaseEdge, "Voxels along each edge of a phase")->capture_default_str();
    program.add_option("--runs", options.runs, "Times that each is read in each way")->capture_default_str();
    program.add_option("--one", options.one, "Reads FILE once: here or reader")
        ->check(CLI::IsMember({"here", "reader"}));
    program.add_flag("--watch", options.watches,
                     "Watches a program instead, which stands with its arguments behind --");
    program.add_option("--seconds", options.seconds, "After which the watched program is ended");
    CLI11_PARSE(program, argc, argv);
    if (!options.one.empty() && !options.files.empty()) return readOne(options);
    if (options.watches) {
        const WatchedRun run = watch(options.files, options.seconds);
        fmt::print("{:.2f} s, at most {:.0f} MiB\n", run.seconds, run.peakMebibytes);
        return 0;
    }
    const TemporaryFolder folder;
    if (options.files.empty()) {
        options.files = {folder.file(fmt::format("{}-cube.nrrd", options.edge)),
                         folder.file(fmt::format("{}-of-{}-cube.nrrd", options.phases, options.phaseEdge))};
        writeSector(options.files[0], options.edge, 1);
        writeSector(options.files[1], options.phaseEdge, options.phases);
    }
    fmt::print("| volume | | s | MiB | times the file |\n|---|---|---|---|---|\n");
    bool all = true;
    for (const std::string& file : options.files)
        all = measure(std::filesystem::canonical("/proc/self/exe").string(), file, folder.path(), options.runs) && all;
    return all ? 0 : 1;
}
