// The adaptive OTF beside the same stages with OpenCV, in turn in one run.
#include <fmt/format.h>
#include <tbb/global_control.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <chrono>
#include <functional>
#include <vector>

#include "processing/adaptive/adaptive_otf.h"
#include "processing/median.h"
#include "processing/phantom/phantom.h"
#include "tests/benchmarks/opencv_otf.h"

namespace echolucent::bench {

namespace {

/// The cell means of both may differ by this much, normalised intensity: at the volume's sides they count samples
/// differently.
constexpr double largestDifference = 0.2;
/// Before any run counts, one run fills caches and page tables.
constexpr int warmUps = 2;

double millisecondsOf(const std::function<void()>& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

/// Prints a line; false where the two do not find the same cell means.
bool measure(const char* name, const Volume& volume, const Viewpoint& view, int runs) {
    const AdaptiveOtfConfig config;
    OpenCvOtf openCv(volume, view, config);
    std::vector<double> ours, theirs;
    double difference = 0.0;
    for (int i = -warmUps; i < runs; ++i) {
        auto otf = adaptOpacity(volume, view, config);
        const double total = millisecondsOf([&] { otf = adaptOpacity(volume, view, config); });
        const double contender = millisecondsOf([&] { (void)openCv.run(); });
        difference = std::max(difference, openCv.differenceTo(*otf));
        if (i < 0) continue;
        ours.push_back(total);
        theirs.push_back(contender);
    }
    const double total = medianOf(ours), contender = medianOf(theirs);
    fmt::print("{:<12}{:>12.3f}{:>12.3f}{:>12.1f}{:>22.4f}\n", name, total, contender, contender / total, difference);
    return difference < largestDifference;
}

bool run(int runs) {
    const tbb::global_control oneThread(tbb::global_control::max_allowed_parallelism, 1);
    const auto volume = makePhantom(defaultPhantom(PhantomScene::shapes));
    Viewpoint oblique;
    oblique.azimuthDegrees = 20.0;
    oblique.elevationDegrees = -12.0;
    fmt::print("{:<12}{:>12}{:>12}{:>12}{:>22}\n", "view", "ours, ms", "OpenCV, ms", "ratio", "cell means differ by");
    const bool axis = measure("axis", *volume, Viewpoint{}, runs);
    return measure("oblique", *volume, oblique, runs) && axis;
}

}  // namespace

}  // namespace echolucent::bench

int main(int count, char** arguments) {
    CLI::App program("Times the adaptive OTF beside the same stages with OpenCV; medians, one thread");
    int runs = 21;
    program.add_option("--runs", runs, "Runs of which the median is taken")
        ->check(CLI::Range(1, 100000))
        ->capture_default_str();
    CLI11_PARSE(program, count, arguments);
    return echolucent::bench::run(runs) ? 0 : 1;
}
