#include "processing/sides/grain.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

#include "processing/parallel.h"

namespace echolucent {

namespace {

constexpr std::int64_t mostRows = 1500;  // along each axis
constexpr std::int64_t partsOfRows = 16;
constexpr double meanOver = 0.1;      // of the data's extent
constexpr std::size_t leastRun = 8;   // voxels: a shorter run of data tells nothing
constexpr std::size_t mostLags = 64;  // voxels

/// Sums of products of intensities, less their mean, by the distance in voxels.
struct LagProducts {
    std::array<double, mostLags> sum{}, count{};
};

/// Takes the mean over 2 `half` + 1 voxels off a run of intensities.
std::vector<double> withoutMean(const std::vector<double>& run, std::size_t half) {
    std::vector<double> until(run.size() + 1), rest(run.size());
    std::partial_sum(run.begin(), run.end(), until.begin() + 1);
    for (std::size_t i = 0; i < run.size(); ++i) {
        const std::size_t from = i - std::min(i, half), to = std::min(run.size(), i + half + 1);
        rest[i] = run[i] - (until[to] - until[from]) / static_cast<double>(to - from);
    }
    return rest;
}

void addRun(const std::vector<double>& run, std::size_t half, LagProducts& products) {
    if (run.size() < leastRun) return;
    const std::vector<double> rest = withoutMean(run, half);
    const std::size_t lags = std::min({mostLags, half + 2, rest.size()});
    for (std::size_t lag = 0; lag < lags; ++lag) {
        double sum = 0.0;
        for (std::size_t i = lag; i < rest.size(); ++i) sum += rest[i] * rest[i - lag];
        products.sum[lag] += sum;
        products.count[lag] += static_cast<double>(rest.size() - lag);
    }
}

/// The distance in voxels at which the autocorrelation has fallen to a half; 0 if it never does, or without echo.
double halfWidthOf(const LagProducts& products) {
    if (!(products.sum[0] > 0.0)) return 0.0;
    const double whole = products.sum[0] / products.count[0];
    double before = 1.0;
    for (std::size_t lag = 1; lag < mostLags && products.count[lag] > 0.0; ++lag) {
        const double here = products.sum[lag] / products.count[lag] / whole;
        if (here <= 0.5) return static_cast<double>(lag - 1) + (before - 0.5) / (before - here);
        before = here;
    }
    return 0.0;
}

/// The products along one axis.
LagProducts productsAlong(const Volume& volume, std::size_t axis, std::size_t half, const Progress& progress) {
    const VolumeGeometry& geometry = volume.geometry();
    const std::size_t across = (axis + 1) % 3, other = (axis + 2) % 3;
    const std::int64_t rows = geometry.size[across] * geometry.size[other], taken = std::min(rows, mostRows);
    std::array<std::int64_t, 3> next{};
    next[axis] = 1;
    const std::int64_t step = geometry.offset(next[0], next[1], next[2]);
    // A fixed number of parts, so that sums have the same shape for any number of threads.
    std::vector<LagProducts> parts(static_cast<std::size_t>(partsOfRows));
    parallelFor(std::int64_t{0}, partsOfRows, [&](std::int64_t part) {
        std::vector<double> run;
        for (std::int64_t i = part * taken / partsOfRows; i < (part + 1) * taken / partsOfRows; ++i) {
            if (progress.cancelled()) return;
            const std::int64_t row = (2 * i + 1) * rows / (2 * taken);
            std::array<std::int64_t, 3> place{};
            place[across] = row % geometry.size[across];
            place[other] = row / geometry.size[across];
            const std::int64_t first = geometry.offset(place[0], place[1], place[2]);
            for (std::int64_t at = 0; at < geometry.size[axis]; ++at) {
                const std::int64_t voxel = first + at * step;
                if (volume.hasData(voxel)) {
                    run.push_back(volume.normalisedIntensity(voxel));
                    continue;
                }
                addRun(run, half, parts[static_cast<std::size_t>(part)]);
                run.clear();
            }
            addRun(run, half, parts[static_cast<std::size_t>(part)]);
            run.clear();
        }
    });
    LagProducts all;
    for (const LagProducts& part : parts)
        for (std::size_t lag = 0; lag < mostLags; ++lag) {
            all.sum[lag] += part.sum[lag];
            all.count[lag] += part.count[lag];
        }
    return all;
}

}  // namespace

std::optional<Vec3> grainMm(const Volume& volume, const Progress& progress) {
    const Vec3 box = volume.dataBox().sizeMm();
    const double windowMm = meanOver * std::cbrt(box[0] * box[1] * box[2]);
    Vec3 grain;
    for (int axis = 0; axis < 3; ++axis) {
        const double spacing = volume.geometry().spacing[axis];
        const auto half = static_cast<std::size_t>(std::clamp(windowMm / spacing / 2.0, 1.0, 1e6));
        const LagProducts products = productsAlong(volume, static_cast<std::size_t>(axis), half, progress);
        if (progress.cancelled()) return std::nullopt;
        grain[axis] = 2.0 * spacing * std::max(1.0, halfWidthOf(products));
    }
    return grain;
}

double grainAlong(const Vec3& direction, const Vec3& grainMm) {
    double squares = 0.0;
    for (int axis = 0; axis < 3; ++axis)
        squares += (direction[axis] / grainMm[axis]) * (direction[axis] / grainMm[axis]);
    return 1.0 / std::sqrt(squares);
}

}  // namespace echolucent
