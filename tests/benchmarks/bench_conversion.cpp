// echolucent-bench-conversion: how long the scan conversion of a polar volume takes, and how far its result lies from
// the function that the polar volume was sampled from.
#include <fmt/format.h>
#include <tbb/global_control.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "processing/scan_conversion/scan_conversion.h"

using namespace echolucent;

namespace {

struct Probe {
    std::string name;
    EvenPolar even;
};

/// A volume 100 mm deep and about as wide, whatever the number of samples.
std::vector<Probe> probes(std::int64_t edge) {
    const double step = 99.5 / static_cast<double>(edge - 1);
    return {{"linear", {PolarKind::linear, 0, step, {-40, 40}, {-40, 40}, 0, 0}},
            {"convex", {PolarKind::convex, 0, step, {-35, 35}, {-40, 40}, 40, 0}},
            {"sector", {PolarKind::wobbler, 0, step, {-40, 40}, {-40, 40}, 0, 0}},
            {"wobbler", {PolarKind::wobbler, 0, step, {-35, 35}, {-30, 30}, 40, 25}}};
}

/// A smooth echo between 0 and 1 with waves of 20 mm.
double echoAt(const Vec3& mm) {
    const double turn = 2 * std::numbers::pi / 20;
    return 0.5 + (std::sin(turn * mm[0]) + std::sin(turn * mm[1] + 1) + std::sin(turn * mm[2] + 2)) / 6;
}

/// Stored value of an echo of 1.
template <typename Value>
constexpr double white = std::is_same_v<Value, float>          ? 1.0
                         : std::is_same_v<Value, std::uint8_t> ? 255.0
                                                               : 65535.0;

template <typename Value>
Voxels sampled(const PolarGeometry& polar) {
    const auto size = polar.size();
    std::vector<Value> values;
    values.reserve(static_cast<std::size_t>(size[0] * size[1] * size[2]));
    for (std::int64_t plane = 0; plane < size[2]; ++plane)
        for (std::int64_t line = 0; line < size[1]; ++line)
            for (std::int64_t sample = 0; sample < size[0]; ++sample) {
                const Vec3 mm = probeMmFromPolar(
                    polar, {static_cast<double>(sample), static_cast<double>(line), static_cast<double>(plane)});
                const double value = echoAt(mm) * white<Value>;
                values.push_back(static_cast<Value>(std::is_same_v<Value, float> ? value : std::round(value)));
            }
    return values;
}

/// Error as a share of white, over the insonified voxels.
struct Error {
    double mean = 0, largest = 0;
};

template <typename Value>
Error errorOf(const Voxels& voxels, const DataMask& mask, const ConversionGrid& grid) {
    const auto& values = std::get<VoxelArray<Value>>(voxels);
    const auto& size = grid.geometry.size;
    Error error;
    double count = 0;
    std::size_t voxel = 0;
    for (std::int64_t z = 0; z < size[2]; ++z)
        for (std::int64_t y = 0; y < size[1]; ++y)
            for (std::int64_t x = 0; x < size[0]; ++x, ++voxel) {
                if (mask[voxel] == 0) continue;
                const Vec3 mm =
                    grid.probeMmFromVoxel({static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)});
                const double off = std::abs(static_cast<double>(values[voxel]) / white<Value> - echoAt(mm));
                error.mean += off;
                error.largest = std::max(error.largest, off);
                ++count;
            }
    error.mean /= std::max(count, 1.0);
    return error;
}

template <typename Work>
double medianMilliseconds(int runs, const Work& work) {
    std::vector<double> times;
    for (int run = 0; run < runs; ++run) {
        const auto begin = std::chrono::steady_clock::now();
        work();
        times.push_back(std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count());
    }
    std::ranges::nth_element(times, times.begin() + runs / 2);
    return times[static_cast<std::size_t>(runs / 2)];
}

template <typename Value>
void printRow(const Probe& probe, const char* type, std::int64_t edge, int runs) {
    const PolarGeometry polar = polarGeometry(probe.even, {edge, edge, edge});
    ConversionMemory memory;
    memory.bytesPerVoxel = sizeof(Value);
    memory.phaseBytes = edge * edge * edge * memory.bytesPerVoxel;
    const ConversionGrid grid = conversionGrid(polar, memory);
    const Voxels voxels = sampled<Value>(polar);
    Voxels converted;
    std::vector<std::uint8_t> mask;
    const double all = medianMilliseconds(runs, [&] {
        const ScanConversion conversion(polar, grid);
        mask = conversion.mask();
        converted = *conversion.convert(voxels);
    });
    const ScanConversion conversion(polar, grid);
    const double next = medianMilliseconds(runs, [&] { converted = *conversion.convert(voxels); });
    const Error error = errorOf<Value>(converted, mask, grid);
    const auto& size = grid.geometry.size;
    fmt::print("| {} | {} | {} x {} x {} | {:.2f} | {:.0f} % | {:.0f} | {:.0f} | {:.4f} | {:.4f} |\n", probe.name, type,
               size[0], size[1], size[2], grid.geometry.spacing[0],
               100.0 * static_cast<double>(std::count(mask.begin(), mask.end(), 1)) / static_cast<double>(mask.size()),
               all, next, error.mean, error.largest);
}

}  // namespace

int main(int count, char** arguments) {
    CLI::App program("Times the scan conversion on two threads, and measures its error against a closed form");
    std::int64_t edge = 199;
    int runs = 25;
    program.add_option("--edge", edge, "Samples, lines and planes; the grid has as many voxels")
        ->check(CLI::Range(8, 512))
        ->capture_default_str();
    program.add_option("--runs", runs, "Runs of which the median is taken")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    CLI11_PARSE(program, count, arguments);
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 2);
    fmt::print(
        "| probe | type | grid | spacing, mm | insonified | first phase, ms | next phase, ms | mean error | "
        "largest error |\n| --- | --- | --- | --- | --- | --- | --- | --- | --- |\n");
    for (const Probe& probe : probes(edge)) {
        printRow<std::uint8_t>(probe, "uint8", edge, runs);
        printRow<std::uint16_t>(probe, "uint16", edge, runs);
        printRow<float>(probe, "float32", edge, runs);
    }
    return 0;
}
