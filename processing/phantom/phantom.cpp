#include "processing/phantom/phantom.h"

#include <algorithm>

#include "processing/choice_names.h"
#include "processing/parallel.h"
#include "processing/phantom/phantom_scene.h"
#include "processing/phantom/polar_sampling.h"
#include "processing/phantom/speckle.h"

namespace echolucent {

namespace {

constexpr ChoiceNames<3> sceneNames{"shapes", "fetus", "empty"};

double whiteLevelOf(int bits) { return bits == 8 ? 255.0 : bits == 12 ? 4095.0 : 65535.0; }

/// Adds speckle to the painted slices [first, last), compresses and stores them.
template <typename Stored>
void storeSlices(const PhantomConfig& config, const std::array<std::int64_t, 3>& size,
                 const std::vector<float>& painted, std::int64_t first, std::int64_t last, const Progress& progress,
                 std::vector<Stored>& stored) {
    const std::int64_t width = size[0], height = size[1], padded = paddedRow(width);
    std::vector<float> echo(static_cast<std::size_t>(padded));
    std::vector<std::uint16_t> row(static_cast<std::size_t>(padded));
    const EchoFinish finish{static_cast<float>(config.speckle), static_cast<float>(config.logCompressDecibel),
                            static_cast<float>(whiteLevelOf(config.bits))};
    const auto storeSlice = [&](std::int64_t z, const float* rayleigh, std::int64_t stride) {
        for (std::int64_t y = 0; y < height && !progress.cancelled(); ++y) {
            const std::int64_t offset = width * (y + height * z);
            std::copy_n(painted.begin() + offset, width, echo.begin());
            finishRow(echo.data(), rayleigh == nullptr ? nullptr : rayleigh + y * stride, padded, finish, row.data());
            std::transform(row.begin(), row.begin() + width, stored.begin() + offset,
                           [](std::uint16_t value) { return static_cast<Stored>(value); });
        }
    };
    if (config.speckle > 0)
        makeSpeckle({config.seed, size, config.speckleSize}, first, last, storeSlice);
    else
        for (std::int64_t z = first; z < last; ++z) storeSlice(z, nullptr, 0);
}

/// The painted echoes as stored values. Empty if cancelled.
template <typename Stored>
std::optional<Voxels> storedVoxels(const PhantomConfig& config, const std::array<std::int64_t, 3>& size,
                                   const std::vector<float>& painted, const Progress& progress) {
    std::vector<Stored> stored(painted.size());
    constexpr std::int64_t slicesAtOnce = 28;
    const std::int64_t chunks = (size[2] + slicesAtOnce - 1) / slicesAtOnce;
    parallelFor(std::int64_t{0}, chunks, [&](std::int64_t chunk) {
        if (progress.cancelled()) return;
        const std::int64_t first = chunk * slicesAtOnce;
        storeSlices(config, size, painted, first, std::min(first + slicesAtOnce, size[2]), progress, stored);
    });
    if (progress.cancelled()) return std::nullopt;
    progress.at(1.0);
    return Voxels(std::move(stored));
}

/// Brings values from the order of painting (lines, planes, samples) to that of a polar volume.
template <typename Stored>
std::vector<Stored> samplesFirst(const VoxelArray<Stored>& painted, const std::array<std::int64_t, 3>& size) {
    std::vector<Stored> ordered(painted.size());
    const auto [samples, lines, planes] = size;
    parallelFor(std::int64_t{0}, planes, [&, samples = samples, lines = lines, planes = planes](std::int64_t plane) {
        for (std::int64_t line = 0; line < lines; ++line)
            for (std::int64_t sample = 0; sample < samples; ++sample)
                ordered[static_cast<std::size_t>(sample + samples * (line + lines * plane))] =
                    painted[static_cast<std::size_t>(line + lines * (plane + planes * sample))];
    });
    return ordered;
}

/// The scene as sampled, first index fastest. Empty if cancelled.
std::optional<Voxels> sampledScene(const PhantomConfig& config, const PhantomSampling& sampling,
                                   const Progress& progress) {
    const std::vector<float> painted = paintedEchoes(buildScenery(config), config, sampling, progress);
    if (painted.empty()) return std::nullopt;
    progress.at(0.5);
    return config.bits == 8 ? storedVoxels<std::uint8_t>(config, sampling.size, painted, progress)
                            : storedVoxels<std::uint16_t>(config, sampling.size, painted, progress);
}

}  // namespace

std::optional<PhantomScene> phantomSceneFromName(std::string_view name) {
    return choiceNamed<PhantomScene>(sceneNames, name);
}

std::string_view nameOf(PhantomScene scene) { return nameIn(sceneNames, scene); }

std::optional<Volume> makePhantom(const PhantomConfig& config, const Progress& progress) {
    auto voxels = sampledScene(config, gridSampling(config), progress);
    if (!voxels) return std::nullopt;
    return Volume(phantomGeometry(config), std::move(*voxels), whiteLevelOf(config.bits));
}

PhantomConfig configOnGrid(PhantomConfig config, const ConversionGrid& grid) {
    config.size = grid.geometry.size;
    config.spacing = grid.geometry.spacing;
    return config;
}

std::optional<Voxels> makePolarPhantom(const PhantomConfig& config, const PolarGeometry& polar,
                                       const ConversionGrid& grid, const Progress& progress) {
    auto voxels = sampledScene(config, polarSampling(polar, grid), progress);
    if (!voxels) return std::nullopt;
    return std::visit([&](const auto& values) -> Voxels { return samplesFirst(values, polar.size()); }, *voxels);
}

}  // namespace echolucent
