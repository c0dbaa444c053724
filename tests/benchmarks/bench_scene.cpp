#include "tests/benchmarks/bench_scene.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <optional>
#include <utility>

#include "io/study/study.h"
#include "processing/adaptive/adaptive_otf.h"
#include "processing/intensity/no_data.h"

namespace echolucent::bench {

namespace {

struct RealVolume {
    const char* name;
    const char* file;
    BeamAxis beamAxis;
};

/// The beam axes were found by looking at the pictures: they tell where the probe was.
constexpr std::array<RealVolume, 4> realVolumes{{
    {"fetal chest", "fetal_chest_iso0.3mm.mha", BeamAxis::plusY},
    {"adult heart", "adult_heart_256.nrrd", BeamAxis::plusZ},
    {"fetal heart", "fetal_heart_4d_128x128x128x20.nrrd", BeamAxis::plusY},
    {"spine phantom", "spine_phantom_freehand.mha", BeamAxis::plusZ},
}};

Viewpoint obliqueView(BeamAxis beamAxis) {
    Viewpoint view;
    view.beamAxis = beamAxis;
    view.azimuthDegrees = 20.0;
    view.elevationDegrees = -12.0;
    return view;
}

std::optional<BenchVolume> readRealVolume(const std::string& folder, const RealVolume& real,
                                          std::vector<Skipped>& skipped) {
    const std::string path = (std::filesystem::path(folder) / real.file).string();
    if (!std::filesystem::exists(path)) {
        skipped.push_back({real.name, "its file is not there"});
        return std::nullopt;
    }
    ReadOptions options;
    options.guessNoData = false;
    const auto study = readStudy(path, options);
    if (!study) {
        skipped.push_back({real.name, study.error().sentence()});
        return std::nullopt;
    }
    BenchVolume volume{real.name, study->phases.front(), nullptr, obliqueView(real.beamAxis)};
    DataMask mask = guessDataMask(*volume.volume);
    if (!mask.empty()) volume.masked = std::make_shared<const Volume>(volume.volume->withDataMask(std::move(mask)));
    return volume;
}

float trilinearAt(const VoxelArray<std::uint8_t>& voxels, const VolumeGeometry& geometry, const Vec3& position) {
    std::array<std::int64_t, 3> low{}, high{};
    std::array<float, 3> share{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double at = position[static_cast<int>(axis)];
        low[axis] = static_cast<std::int64_t>(at);
        high[axis] = std::min(low[axis] + 1, geometry.size[axis] - 1);
        share[axis] = static_cast<float>(at - static_cast<double>(low[axis]));
    }
    float sum = 0.0f;
    for (int corner = 0; corner < 8; ++corner) {
        const auto& x = corner & 1 ? high : low;
        const auto& y = corner & 2 ? high : low;
        const auto& z = corner & 4 ? high : low;
        const float weight = (corner & 1 ? share[0] : 1 - share[0]) * (corner & 2 ? share[1] : 1 - share[1]) *
                             (corner & 4 ? share[2] : 1 - share[2]);
        sum += weight * static_cast<float>(voxels[static_cast<std::size_t>(geometry.offset(x[0], y[1], z[2]))]);
    }
    return sum;
}

/// The foremost corner's depth along `forward` of the box between two corners, mm from the grid origin.
double foremostDepth(const RenderBox& box, const Vec3& forward) {
    double depth = 0.0;
    for (int axis = 0; axis < 3; ++axis)
        depth += std::min(forward[axis] * box.low[axis], forward[axis] * box.high[axis]);
    return depth;
}

}  // namespace

BenchVolume benchPhantom(PhantomScene scene, const std::array<std::int64_t, 3>& size) {
    PhantomConfig config = defaultPhantom(scene);
    config.size = size;
    BenchVolume volume{"phantom " + std::string(nameOf(scene)), nullptr, nullptr, obliqueView(BeamAxis::plusZ)};
    volume.volume = std::make_shared<const Volume>(*makePhantom(config));
    return volume;
}

std::vector<BenchVolume> benchVolumes(const std::string& folder, std::vector<Skipped>& skipped) {
    const std::array<std::int64_t, 3> paperSize{199, 197, 199};
    std::vector<BenchVolume> volumes{benchPhantom(PhantomScene::shapes, paperSize),
                                     benchPhantom(PhantomScene::fetus, paperSize)};
    for (const RealVolume& real : realVolumes)
        if (auto volume = readRealVolume(folder, real, skipped)) volumes.push_back(std::move(*volume));
    return volumes;
}

BenchVolume doubled(const BenchVolume& volume) {
    const VolumeGeometry& old = volume.volume->geometry();
    const auto& voxels = std::get<VoxelArray<std::uint8_t>>(volume.volume->voxels());
    VolumeGeometry geometry = old;
    Vec3 scale;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const int component = static_cast<int>(axis);
        geometry.size[axis] = 2 * old.size[axis];
        scale[component] = static_cast<double>(old.size[axis] - 1) / static_cast<double>(geometry.size[axis] - 1);
        geometry.spacing[component] = old.spacing[component] * scale[component];
    }
    std::vector<std::uint8_t> finer(static_cast<std::size_t>(geometry.voxelCount()));
    tbb::parallel_for(std::int64_t{0}, geometry.size[2], [&](std::int64_t z) {
        for (std::int64_t y = 0; y < geometry.size[1]; ++y)
            for (std::int64_t x = 0; x < geometry.size[0]; ++x) {
                const Vec3 position{static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)};
                const float value = trilinearAt(voxels, old, position.mul(scale));
                finer[static_cast<std::size_t>(geometry.offset(x, y, z))] =
                    static_cast<std::uint8_t>(std::lround(value));
            }
    });
    BenchVolume twice = volume;
    twice.volume = std::make_shared<const Volume>(geometry, std::move(finer), volume.volume->whiteLevel());
    twice.masked = nullptr;
    return twice;
}

NamedCurve parabolicCurve() { return {"parabolic", PowerCurve{2, 0.5}}; }

std::vector<NamedCurve> benchCurves(const BenchVolume& volume) {
    // The adaptive curve is the one that the program has: the method knows what is no data even where the comparison
    // does not.
    const Volume& seen = volume.masked ? *volume.masked : *volume.volume;
    const auto adaptive = adaptOpacity(seen, volume.view, AdaptiveOtfConfig{});
    return {{"linear", LinearCurve{}}, parabolicCurve(), {"adaptive", adaptive->curve}};
}

RayCastSettings benchSettings(const BenchVolume& volume, int size, double turnDegrees) {
    const VolumeGeometry& geometry = volume.volume->geometry();
    Viewpoint view = volume.view;
    RayCastSettings settings;
    settings.width = settings.height = size;
    settings.camera = defaultCamera(geometry, view, 1.0);
    constexpr double defaultMargin = 1.04, wantedMargin = 1.5;  // two thirds
    settings.camera.heightMm *= wantedMargin / defaultMargin;
    view.azimuthDegrees += turnDegrees;
    settings.camera.frame = frameOf(view);
    settings.box = RenderBox{
        {0, 0, 0},
        geometry.gridMmFromVoxel({static_cast<double>(geometry.size[0] - 1), static_cast<double>(geometry.size[1] - 1),
                                  static_cast<double>(geometry.size[2] - 1)})};
    settings.front =
        CuttingFace{settings.camera.frame.forward, foremostDepth(*settings.box, settings.camera.frame.forward)};
    return settings;
}

}  // namespace echolucent::bench
