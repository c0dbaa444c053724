// What the reader process costs: volumes read in this process and by one of its own, in turn and warm.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "io/restricted/restricted_reader.h"
#include "io/restricted/shared_voxel_memory.h"
#include "io/voxels/voxel_bytes.h"

namespace {

using Clock = std::chrono::steady_clock;

/// Milliseconds that `read` takes; below 0 where nothing was read.
template <typename Read>
double millisecondsOf(const Read& read) {
    const auto begin = Clock::now();
    const auto study = read();
    const double milliseconds = std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
    if (study) return milliseconds;
    fmt::print(stderr, "{}\n", study.error().sentence());
    return -1;
}

/// Reads in this process, into memory of the kind that a reader shares: what is left of the cost is the other process.
echolucent::Result<echolucent::Study> readIntoSharedMemory(const std::string& path,
                                                           echolucent::restricted::SharedVoxelMemory& memory) {
    std::pmr::memory_resource& before = echolucent::voxelMemory();
    echolucent::setVoxelMemory(memory);
    auto study = echolucent::readStudy(path);
    echolucent::setVoxelMemory(before);
    return study;
}

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

/// Prints a row of the table. False where the file cannot be read.
bool measure(const std::string& path, int runs) {
    std::vector<double> here, inShared, started, waiting;
    echolucent::restricted::SharedVoxelMemory memory;
    for (int run = 0; run < runs; ++run) {
        here.push_back(millisecondsOf([&] { return echolucent::readStudy(path); }));
        started.push_back(millisecondsOf([&] { return echolucent::restricted::readStudy(path); }));
        inShared.push_back(millisecondsOf([&] { return readIntoSharedMemory(path, memory); }));
        echolucent::restricted::prepareReader(echolucent::restricted::Readiness::once);
        // One that waits has loaded its libraries before it is needed: here it does so while the file is read here.
        here.push_back(millisecondsOf([&] { return echolucent::readStudy(path); }));
        waiting.push_back(millisecondsOf([&] { return echolucent::restricted::readStudy(path); }));
        if (here.back() < 0 || inShared.back() < 0 || started.back() < 0 || waiting.back() < 0) return false;
    }
    const double plain = median(here), shared = median(inShared), fresh = median(started), ready = median(waiting);
    fmt::print("| {} | {:.1f} | {:.1f} | {:.1f} ({:+.1f} ms, {:.2f} x) | {:.1f} ({:+.1f} ms, {:.2f} x) |\n",
               path.substr(path.rfind('/') + 1), plain, shared, fresh, fresh - plain, fresh / plain, ready,
               ready - plain, ready / plain);
    return true;
}

}  // namespace

int main(int argc, char** argv) {
    int runs = 15;
    std::vector<std::string> files;
    CLI::App program{"Reads volumes in this process and by a reader process, side by side"};
    program.add_option("FILE", files, "Volumes")->required();
    program.add_option("--runs", runs, "Times that each is read in each way, of which the medians are told")
        ->check(CLI::PositiveNumber)
        ->capture_default_str();
    CLI11_PARSE(program, argc, argv);
    fmt::print(
        "| volume | in this process, ms | the same, in shared memory | by a reader that is started | by one that waits "
        "|\n"
        "|---|---|---|---|---|\n");
    for (const std::string& file : files)
        if (!measure(file, runs)) return 1;
    return 0;
}
