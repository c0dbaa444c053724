#include "processing/phantom/phantom.h"

#include <algorithm>

#include "processing/choice_names.h"
#include "processing/parallel.h"
#include "processing/phantom/phantom_scene.h"
#include "processing/phantom/speckle.h"

namespace echolucent {

namespace {

constexpr ChoiceNames<3> sceneNames{"shapes", "fetus", "empty"};

double whiteLevelOf(int bits) { return bits == 8 ? 255.0 : bits == 12 ? 4095.0 : 65535.0; }

/// Speckles, compresses and stores slices [first, last).
template <typename Stored>
void storeSlices(const PhantomConfig& config, const std::vector<float>& painted, std::int64_t first, std::int64_t last,
                 const Progress& progress, std::vector<Stored>& stored) {
    const std::int64_t width = config.size[0], height = config.size[1], padded = paddedRow(width);
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
        makeSpeckle({config.seed, config.size, config.speckleSize}, first, last, storeSlice);
    else
        for (std::int64_t z = first; z < last; ++z) storeSlice(z, nullptr, 0);
}

template <typename Stored>
std::optional<Volume> storedVolume(const PhantomConfig& config, const std::vector<float>& painted,
                                   const Progress& progress) {
    std::vector<Stored> stored(painted.size());
    constexpr std::int64_t slicesAtOnce = 28;
    const std::int64_t chunks = (config.size[2] + slicesAtOnce - 1) / slicesAtOnce;
    parallelFor(std::int64_t{0}, chunks, [&](std::int64_t chunk) {
        if (progress.cancelled()) return;
        const std::int64_t first = chunk * slicesAtOnce;
        storeSlices(config, painted, first, std::min(first + slicesAtOnce, config.size[2]), progress, stored);
    });
    if (progress.cancelled()) return std::nullopt;
    progress.at(1.0);
    return Volume(phantomGeometry(config), std::move(stored), whiteLevelOf(config.bits));
}

}  // namespace

std::optional<PhantomScene> phantomSceneFromName(std::string_view name) {
    return choiceNamed<PhantomScene>(sceneNames, name);
}

std::string_view nameOf(PhantomScene scene) { return nameIn(sceneNames, scene); }

std::optional<Volume> makePhantom(const PhantomConfig& config, const Progress& progress) {
    const std::vector<float> painted = paintedVoxels(buildScenery(config), config, progress);
    if (painted.empty()) return std::nullopt;
    progress.at(0.5);
    return config.bits == 8 ? storedVolume<std::uint8_t>(config, painted, progress)
                            : storedVolume<std::uint16_t>(config, painted, progress);
}

}  // namespace echolucent
