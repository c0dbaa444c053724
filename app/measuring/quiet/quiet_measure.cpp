#include "app/measuring/quiet/quiet_measure.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "app/measuring/run_time.h"
#include "processing/adaptive/adaptive_otf.h"
#include "processing/comparison/classification_measures.h"
#include "processing/median.h"
#include "processing/phantom/speckle.h"
#include "processing/speckle_reduction/gaussian_filter.h"

namespace echolucent::cli {

namespace {

constexpr std::int64_t edge = 64;
constexpr double fluid = 14, tissue = 85, object = 170;
constexpr double middle = (edge - 1) / 2.0;

/// A volume with the echo of a function, under speckle.
Volume painted(const std::function<double(const Vec3&)>& echoAt, std::uint64_t seed) {
    VolumeGeometry geometry;
    geometry.size = {edge, edge, edge};
    std::vector<std::uint8_t> voxels(static_cast<std::size_t>(geometry.voxelCount()));
    std::vector<float> echo(edge);
    std::vector<std::uint16_t> stored(edge);
    makeSpeckle({seed, geometry.size, 2}, 0, edge, [&](std::int64_t z, const float* rayleigh, std::int64_t stride) {
        for (std::int64_t y = 0; y < edge; ++y) {
            for (std::int64_t x = 0; x < edge; ++x)
                echo[static_cast<std::size_t>(x)] = static_cast<float>(
                    echoAt({static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)}));
            finishRow(echo.data(), rayleigh + y * stride, edge, EchoFinish{}, stored.data());
            for (std::int64_t x = 0; x < edge; ++x)
                voxels[static_cast<std::size_t>(geometry.offset(x, y, z))] =
                    static_cast<std::uint8_t>(stored[static_cast<std::size_t>(x)]);
        }
    });
    return Volume(geometry, std::move(voxels), 255.0);
}

/// Fluid at negative distances, tissue at positive ones, and a ramp between.
double rampAtDistance(double distance) {
    constexpr double width = 4.0;
    return fluid + (tissue - fluid) * std::clamp(distance / width + 0.5, 0.0, 1.0);
}

/// Mean voxel values over the distance from a structure, in bins of one unit. Leaves out a rim at the borders.
std::vector<double> profileOf(const Volume& volume, const std::function<double(const Vec3&)>& distance, int bins) {
    constexpr std::int64_t rim = 8;
    std::vector<double> sums(static_cast<std::size_t>(bins)), counts(sums.size());
    for (std::int64_t z = rim; z < edge - rim; ++z)
        for (std::int64_t y = rim; y < edge - rim; ++y)
            for (std::int64_t x = rim; x < edge - rim; ++x) {
                const double at = distance({static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)});
                const auto bin = static_cast<std::ptrdiff_t>(std::floor(at));
                if (bin < 0 || bin >= bins) continue;
                sums[static_cast<std::size_t>(bin)] += volume.storedValue(volume.geometry().offset(x, y, z));
                counts[static_cast<std::size_t>(bin)] += 1.0;
            }
    for (std::size_t i = 0; i < sums.size(); ++i) sums[i] = counts[i] > 0.0 ? sums[i] / counts[i] : sums[i];
    return sums;
}

/// Where a profile crosses the middle between its ends, units; NaN if it does not.
double crossingOf(const std::vector<double>& profile) {
    const double half = (profile.front() + profile.back()) / 2.0;
    for (std::size_t i = 1; i < profile.size(); ++i) {
        const double before = profile[i - 1] - half, behind = profile[i] - half;
        if (before == behind || before * behind > 0.0) continue;
        return static_cast<double>(i) - 0.5 + before / (before - behind);
    }
    return std::numeric_limits<double>::quiet_NaN();
}

/// How far the filter moves a surface.
double shiftOf(const Volume& volume, const QuietFilter& filter, const std::function<double(const Vec3&)>& distance,
               int bins) {
    return crossingOf(profileOf(filter.run(volume), distance, bins)) - crossingOf(profileOf(volume, distance, bins));
}

/// The remaining share of the contrast between the first and the last bin.
double contrastLeft(const Volume& volume, const QuietFilter& filter, const std::function<double(const Vec3&)>& distance,
                    int bins) {
    const auto before = profileOf(volume, distance, bins), after = profileOf(filter.run(volume), distance, bins);
    return (after.front() - after.back()) / (before.front() - before.back());
}

Volume sector(const Volume& volume) {
    const VolumeGeometry& geometry = volume.geometry();
    std::vector<std::uint8_t> mask(static_cast<std::size_t>(geometry.voxelCount()));
    for (std::int64_t z = 0; z < geometry.size[2]; ++z)
        for (std::int64_t y = 0; y < geometry.size[1]; ++y)
            for (std::int64_t x = 0; x < geometry.size[0]; ++x)
                mask[static_cast<std::size_t>(geometry.offset(x, y, z))] =
                    std::abs(2 * x - geometry.size[0]) < geometry.size[0] / 3 + 2 * z / 3 ? 1 : 0;
    return volume.withDataMask(std::move(mask));
}

double medianTime(const Volume& volume, const QuietFilter& filter, int repeats) {
    std::vector<double> times;
    for (int i = 0; i < repeats; ++i) times.push_back(millisecondsOf([&] { (void)filter.run(volume); }));
    return medianOf(times) / (static_cast<double>(volume.geometry().voxelCount()) * 1e-6);
}

QuietFilter gaussian(double sigma, const std::string& name, const std::string& setting) {
    return {name, setting, SpeckleReduction::light,
            [sigma](const Volume& volume) { return *gaussianFiltered(volume, sigma); }};
}

QuietFilter behind(SpeckleReduction reduction, const std::string& name) {
    return {name, std::string(nameOf(reduction)), reduction,
            [reduction](const Volume& volume) { return *quietVolume(volume, reduction); }};
}

}  // namespace

std::vector<QuietFilter> quietFilters() {
    return {behind(SpeckleReduction::off, "none"),
            gaussian(0.7, "Gaussian, 0.7", ""),
            behind(SpeckleReduction::light, "Gaussian, 1"),
            gaussian(1.6, "Gaussian, 1.6", ""),
            behind(SpeckleReduction::medium, "joint bilateral, one pass"),
            behind(SpeckleReduction::strong, "joint bilateral, two passes")};
}

StructureError structureErrorOf(const QuietFilter& filter, std::uint64_t seed) {
    StructureError error;
    const Vec3 normal = normalized(Vec3(0.2, -0.15, 1.0)), centre(middle, middle, middle);
    const auto alongPlane = [&](const Vec3& at) { return normal.dot(at - centre) + 10.0; };
    const Volume plane = painted([&](const Vec3& at) { return rampAtDistance(alongPlane(at) - 10.0); }, seed);
    error.planeShift = std::abs(shiftOf(plane, filter, alongPlane, 20));

    constexpr double radius = 12.0;
    const auto fromCentre = [&](const Vec3& at) { return length(at - centre); };
    const Volume sphere = painted([&](const Vec3& at) { return rampAtDistance(radius - fromCentre(at)); }, seed);
    error.sphereShift = shiftOf(sphere, filter, fromCentre, 22);

    // Membrane and finger lie along x, so that the first bin holds them alone.
    const auto fromMembrane = [&](const Vec3& at) { return std::abs(at[2] - middle); };
    const Volume membrane = painted([&](const Vec3& at) { return fromMembrane(at) < 1.0 ? tissue : fluid; }, seed);
    error.membrane = contrastLeft(membrane, filter, fromMembrane, 12);
    const auto fromFinger = [&](const Vec3& at) { return std::hypot(at[1] - middle, at[2] - middle); };
    const Volume finger = painted([&](const Vec3& at) { return fromFinger(at) < 2.0 ? object : fluid; }, seed);
    error.finger = contrastLeft(finger, filter, fromFinger, 12);
    return error;
}

QuietTimes quietTimesOf(const QuietFilter& filter, int edgeTimed, int repeats) {
    PhantomConfig config = defaultPhantom(PhantomScene::shapes);
    config.size = {edgeTimed, edgeTimed, edgeTimed};
    const Volume volume = *makePhantom(config);
    return {medianTime(volume, filter, repeats), medianTime(sector(volume), filter, repeats)};
}

std::optional<double> quietContrastOf(const StudyPhantom& phantom, const std::vector<SurfaceRay>& rays,
                                      const QuietFilter& filter) {
    const Viewpoint view;
    const Volume quiet = filter.run(phantom.volume);
    const bool off = filter.named == SpeckleReduction::off;
    const auto otf = adaptOpacity(phantom.volume, view, {}, {}, {off ? nullptr : &quiet, filter.named});
    const std::vector<Classification> curve{otf->curve};
    return measuresOf(quiet, view, rays, curve)->front().contrast.contrastToNoise();
}

}  // namespace echolucent::cli
