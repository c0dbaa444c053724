// Extreme volumes and settings.
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "app/measuring/stability/study_stability.h"
#include "processing/adaptive/adaptive_otf.h"
#include "processing/phantom/splitmix.h"

namespace echolucent::cli {

namespace {

VolumeGeometry geometryOf(std::array<std::int64_t, 3> size, const Vec3& spacing = {1, 1, 1}) {
    VolumeGeometry geometry;
    geometry.size = size;
    geometry.spacing = spacing;
    return geometry;
}

/// A volume whose voxels are a function of their place.
template <typename Stored>
Volume volumeOf(const VolumeGeometry& geometry,
                const std::function<double(std::int64_t, std::int64_t, std::int64_t)>& value,
                std::optional<double> whiteLevel = {}) {
    std::vector<Stored> voxels;
    voxels.reserve(static_cast<std::size_t>(geometry.voxelCount()));
    for (std::int64_t z = 0; z < geometry.size[2]; ++z)
        for (std::int64_t y = 0; y < geometry.size[1]; ++y)
            for (std::int64_t x = 0; x < geometry.size[0]; ++x) voxels.push_back(static_cast<Stored>(value(x, y, z)));
    return Volume(geometry, std::move(voxels), whiteLevel);
}

Volume constantOf(std::array<std::int64_t, 3> size, double value) {
    return volumeOf<std::uint8_t>(geometryOf(size), [value](auto, auto, auto) { return value; });
}

/// Fluid (14) lies before depth z = `at` and tissue (120) behind it, over a ramp of 4 voxels with noise of +-`noise`.
struct Plane {
    double at = 40, noise = 6;
    double operator()(std::int64_t x, std::int64_t y, std::int64_t z) const {
        constexpr double fluid = 14, tissue = 120, ramp = 4;
        const double share = std::clamp((static_cast<double>(z) - at) / ramp + 0.5, 0.0, 1.0);
        const auto counter = static_cast<std::uint64_t>(x + 1000 * (y + 1000 * z));
        const double random = static_cast<double>(splitmix64(counter) >> 11) * 0x1p-53;
        return std::max(0.0, std::round(fluid + share * (tissue - fluid) + noise * (2 * random - 1)));
    }
};

const std::array<std::int64_t, 3> usual{80, 80, 80};

void addPlainVolumes(std::vector<ExtremeCase>& cases) {
    const auto add = [&](const std::string& name, Volume volume) {
        cases.push_back({name, std::move(volume), {}, {}, {}});
    };
    const auto oneBright = [](std::int64_t x, std::int64_t y, std::int64_t z) {
        return x == 40 && y == 40 && z == 40 ? 255.0 : 0.0;
    };
    add("constant 77", constantOf(usual, 77));
    add("all zero", constantOf(usual, 0));
    add("one bright voxel", volumeOf<std::uint8_t>(geometryOf(usual), oneBright));
    add("1 x 1 x 1", constantOf({1, 1, 1}, 9));
    add("1 x 80 x 80", volumeOf<std::uint8_t>(geometryOf({1, 80, 80}), Plane{}));
    add("80 x 1 x 80", volumeOf<std::uint8_t>(geometryOf({80, 1, 80}), Plane{}));
    add("80 x 80 x 1", volumeOf<std::uint8_t>(geometryOf({80, 80, 1}), Plane{}));
    add("narrower than a tube, 3 x 3 x 80", volumeOf<std::uint8_t>(geometryOf({3, 3, 80}), Plane{}));
    add("spacing 1 : 50", volumeOf<std::uint8_t>(geometryOf({60, 60, 8}, {0.1, 0.1, 5}), Plane{4, 6}));
    add("an ordinary surface", volumeOf<std::uint8_t>(geometryOf(usual), Plane{}));
    add("all tubes equal", volumeOf<std::uint8_t>(geometryOf(usual), Plane{40, 0}));
}

void addFloats(std::vector<ExtremeCase>& cases) {
    const auto add = [&](const std::string& name, Volume volume) {
        cases.push_back({name, std::move(volume), {}, {}, {}});
    };
    constexpr float infinity = std::numeric_limits<float>::infinity();
    const auto spoilt = [](std::vector<double> by) {
        return [by = std::move(by)](std::int64_t x, std::int64_t y, std::int64_t z) {
            const auto place = static_cast<std::size_t>(x + 80 * (y + 80 * z));
            return place % 97 == 0 ? by[place / 97 % by.size()] : Plane{}(x, y, z);
        };
    };
    add("NaN and infinite voxels",
        volumeOf<float>(geometryOf(usual), spoilt({std::nan(""), infinity, -infinity}), 255.0));
    add("nothing but NaN", volumeOf<float>(geometryOf(usual), [](auto, auto, auto) { return std::nan(""); }));
    add("voxels of 3e38", volumeOf<float>(geometryOf(usual), [](auto x, auto y, auto z) {
            return (x + 80 * (y + 80 * z)) % 9973 == 0 ? 3e38 : Plane{}(x, y, z);
        }));
    add("tissue one float above fluid",
        volumeOf<float>(
            geometryOf(usual),
            [](auto, auto, auto z) { return static_cast<double>(z < 40 ? 0.5f : std::nextafter(0.5f, 1.0f)); }, 1.0));
    add("tissue equal to fluid, noise only", volumeOf<float>(
                                                 geometryOf(usual),
                                                 [](auto x, auto y, auto z) {
                                                     return Plane{1e9, 6}(x, y, z);
                                                 },
                                                 255.0));
}

}  // namespace

std::vector<ExtremeCase> extremeCases() {
    std::vector<ExtremeCase> cases;
    addPlainVolumes(cases);
    addFloats(cases);
    const Volume plane = volumeOf<std::uint8_t>(geometryOf(usual), Plane{});
    const Viewpoint oblique{.azimuthDegrees = 31, .elevationDegrees = 12};
    cases.push_back({"an ordinary surface, oblique", plane, oblique, {}, {}});
    cases.push_back({"constant 77, oblique", constantOf(usual, 77), oblique, {}, {}});
    cases.push_back({"front behind the volume", plane, withFrontAcross({}, 1e6), {}, {}});
    cases.push_back({"T = 1", plane, {}, {}, 1});
    cases.push_back({"T = 102,400", plane, Viewpoint{}, {}, 320});
    cases.push_back({"d_max = 0", plane, {}, 0.0, {}});
    cases.push_back({"d_max = 1e6", plane, {}, 1e6, {}});
    return cases;
}

bool ExtremeResult::isSound() const {
    constexpr double rounding = 1e-15;
    return finite && (surfaces > 0 || (!message.empty() && deviation <= rounding));
}

ExtremeResult resultOf(const ExtremeCase& extreme, const std::string& reading, const AdaptiveOtfConfig& asRead) {
    AdaptiveOtfConfig config = asRead;
    if (extreme.tubesAcross) {
        config.grid.columns = config.grid.rows = *extreme.tubesAcross;
        config.grid.spacing = static_cast<double>(extreme.volume.geometry().size[0]) / *extreme.tubesAcross;
    }
    // Only the product rule has a d_max.
    if (extreme.dMax) config.curve = ProductRule{*extreme.dMax * config.grid.columns * config.grid.rows};
    const AdaptiveOtf otf = *adaptOpacity(extreme.volume, extreme.view, config);
    ExtremeResult result{extreme.name, reading, otf.message, otf.tubesMeetingVolume, otf.tubesWithWeight};
    const auto initial = sampledOpacities(config.initial, AdaptiveOtf::sampleCount);
    const auto [least, most] = std::minmax_element(otf.curve.opacities.begin(), otf.curve.opacities.end());
    result.leastOpacity = *least;
    result.mostOpacity = *most;
    result.finite = *least >= 0.0 && *most <= 1.0;
    for (std::size_t i = 0; i < initial.size(); ++i) {
        result.finite = result.finite && !std::isnan(otf.logOpacity[i]) && !std::isnan(otf.curve.opacities[i]);
        result.deviation = std::max(result.deviation, std::abs(otf.curve.opacities[i] - initial[i]));
    }
    for (const TubeCore& tube : otf.tubes) {
        result.finite = result.finite && std::isfinite(tube.d);
        for (const auto& value : {tube.lowIntensity, tube.highIntensity, tube.lowIntensityMax, tube.slope})
            result.finite = result.finite && (!value || std::isfinite(*value));
    }
    return result;
}

}  // namespace echolucent::cli
