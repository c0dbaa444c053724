// echolucent-bench-planes: how long a plane of 512 x 512 places through a volume of bytes takes.
#include <fmt/format.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <random>
#include <vector>

#include "processing/sampling/plane_sampling.h"
#include "processing/viewpoint/viewpoint.h"

using namespace echolucent;

namespace {

constexpr std::int64_t edge = 256;  // voxels
constexpr int places = 512;

/// Random bytes, so that no cache is helped; a third of them no data where `masked`.
Volume randomVolume(bool masked) {
    VolumeGeometry geometry;
    geometry.size = {edge, edge, edge};
    std::mt19937 random(1);
    std::vector<std::uint8_t> voxels(static_cast<std::size_t>(geometry.voxelCount()));
    for (std::uint8_t& voxel : voxels) voxel = static_cast<std::uint8_t>(random());
    std::vector<std::uint8_t> mask(voxels.size(), 1);
    std::fill_n(mask.begin(), mask.size() / 3, 0);
    const Volume volume(geometry, Voxels(std::move(voxels)), 255.0);
    return masked ? volume.withDataMask(std::move(mask)) : volume;
}

double medianMilliseconds(const Volume& volume, double degrees) {
    Viewpoint view;
    view.azimuthDegrees = degrees;
    view.elevationDegrees = degrees / 2;
    view.rollDegrees = degrees / 3;
    const ViewFrame frame = frameOf(view);
    PlaneGrid grid;
    grid.columns = grid.rows = places;
    grid.perColumnMm = frame.right * 0.5;
    grid.perRowMm = frame.down * 0.5;
    grid.firstMm = volume.geometry().centreMm() - (grid.perColumnMm + grid.perRowMm) * (places / 2.0);
    constexpr int runs = 101;
    std::vector<double> times;
    for (int run = 0; run < runs; ++run) {
        const auto begin = std::chrono::steady_clock::now();
        const PlaneSamples samples = sampledPlane(volume, grid);
        if (samples.columns != places) return 0;
        times.push_back(std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count());
    }
    std::ranges::nth_element(times, times.begin() + runs / 2);
    return times[runs / 2];
}

}  // namespace

int main() {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 2);
    fmt::print("| plane | all data, ms | a third no data, ms |\n| --- | --- | --- |\n");
    const Volume whole = randomVolume(false), masked = randomVolume(true);
    for (const double degrees : {0.0, 33.0})
        fmt::print("| {} | {:.2f} | {:.2f} |\n", degrees == 0.0 ? "along the grid" : "oblique",
                   medianMilliseconds(whole, degrees), medianMilliseconds(masked, degrees));
    return 0;
}
