#include "processing/theory/two_intensity_volume.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "processing/phantom/speckle.h"
#include "processing/picture/camera.h"
#include "processing/ray_caster/ray_caster.h"
#include "processing/viewpoint/viewpoint.h"

namespace echolucent {

namespace {

constexpr double theoryWhite = 65535.0, echoWhite = 255.0;

void requireSensible(const TwoIntensityVolume& wanted) {
    const auto require = [](bool holds, const std::string& what) {
        if (!holds) throw std::invalid_argument("makeTwoIntensityVolume: " + what);
    };
    const std::string problem = problemOf(wanted.model);
    require(problem.empty(), problem);
    const std::int64_t depth = wanted.model.fluidUnits + wanted.model.tissueUnits;
    require(depth >= 1 && depth <= 4096, "the volume must be from 1 to 4096 units deep");
    require(wanted.edge >= 2 && wanted.edge <= 1024, "the edge must be from 2 to 1024 voxels");
    require(wanted.speckle >= 0.0 && wanted.speckle <= 1.0, "speckle must be from 0 to 1");
    require(wanted.speckleSize >= 0.0 && wanted.speckleSize <= 64.0, "the size of speckle must be from 0 to 64 voxels");
}

VolumeGeometry geometryOf(const TwoIntensityVolume& wanted) {
    VolumeGeometry geometry;
    geometry.size = {wanted.edge, wanted.edge, wanted.model.fluidUnits + wanted.model.tissueUnits};
    return geometry;
}

/// A row of echoes, 0..255, at one depth.
std::vector<float> echoesAt(const TwoIntensityVolume& wanted, std::int64_t z) {
    const auto width = static_cast<std::size_t>(wanted.edge);
    std::vector<float> echoes(static_cast<std::size_t>(paddedRow(wanted.edge)),
                              static_cast<float>(echoWhite * wanted.model.fluid));
    if (z >= wanted.model.fluidUnits)
        std::fill(echoes.begin() + static_cast<std::ptrdiff_t>(width / 2),
                  echoes.begin() + static_cast<std::ptrdiff_t>(width),
                  static_cast<float>(echoWhite * wanted.model.tissue));
    return echoes;
}

class PixelSum {
public:
    void add(double pixel) {
        m_least = m_count == 0 ? pixel : std::min(m_least, pixel);
        m_most = m_count == 0 ? pixel : std::max(m_most, pixel);
        ++m_count;
        const double from = pixel - m_mean;  // Welford's sums lose no digits
        m_mean += from / m_count;
        m_squares += from * (pixel - m_mean);
    }
    [[nodiscard]] HalfField half() const { return {m_mean, std::sqrt(m_squares / m_count), m_least, m_most}; }

private:
    int m_count = 0;
    double m_mean = 0.0, m_squares = 0.0, m_least = 0.0, m_most = 0.0;
};

}  // namespace

Volume makeTwoIntensityVolume(const TwoIntensityVolume& wanted) {
    requireSensible(wanted);
    const VolumeGeometry geometry = geometryOf(wanted);
    const std::int64_t width = geometry.size[0], height = geometry.size[1], depth = geometry.size[2];
    std::vector<std::uint16_t> voxels(static_cast<std::size_t>(geometry.voxelCount()));
    std::vector<std::uint16_t> row(static_cast<std::size_t>(paddedRow(width)));
    const EchoFinish finish{static_cast<float>(wanted.speckle), 0.0F, static_cast<float>(theoryWhite)};
    const auto store = [&](std::int64_t z, const float* rayleigh, std::int64_t stride) {
        const std::vector<float> echoes = echoesAt(wanted, z);
        for (std::int64_t y = 0; y < height; ++y) {
            finishRow(echoes.data(), rayleigh == nullptr ? nullptr : rayleigh + y * stride, paddedRow(width), finish,
                      row.data());
            std::copy_n(row.begin(), width, voxels.begin() + geometry.offset(0, y, z));
        }
    };
    if (wanted.speckle > 0.0)
        makeSpeckle({wanted.seed, geometry.size, wanted.speckleSize}, 0, depth, store);
    else
        for (std::int64_t z = 0; z < depth; ++z) store(z, nullptr, 0);
    return Volume(geometry, std::move(voxels), theoryWhite);
}

RayCastSettings theorySettings(const VolumeGeometry& geometry) {
    RayCastSettings settings;
    settings.width = static_cast<int>(geometry.size[0]);
    settings.height = static_cast<int>(geometry.size[1]);
    settings.camera = defaultCamera(geometry, Viewpoint{}, static_cast<double>(settings.width) / settings.height);
    settings.camera.heightMm = static_cast<double>(geometry.size[1]) * geometry.spacing[1];
    settings.step = 1.0;
    settings.interpolation = Interpolation::nearest;
    settings.colourMap = ColourMap::grey;
    settings.terminationTransmittance = 0.0;
    return settings;
}

MeasuredPixels measuredPixels(const Volume& volume, const OpacityCurve& curve, double background) {
    const Picture picture = castRays(volume, curve, theorySettings(volume.geometry())).value();
    PixelSum fluid, tissue;
    const auto width = static_cast<std::size_t>(picture.width);
    for (std::size_t i = 0; i * 4 < picture.rgba.size(); ++i) {
        const double grey = static_cast<double>(picture.rgba[i * 4]);
        const double through = 1.0 - static_cast<double>(picture.rgba[i * 4 + 3]);
        (i % width < width / 2 ? fluid : tissue).add(grey + through * background);
    }
    return {fluid.half(), tissue.half()};
}

RayLayer speckledLayer(const RayLayer& layer, const OpacityCurve& curve, double speckle) {
    constexpr int shares = 4096;  // of the Rayleigh distribution, each as large as the others
    double alpha = 0.0, light = 0.0;
    for (int i = 0; i < shares; ++i) {
        const double above = (i + 0.5) / shares;                                       // the share of larger values
        const double rayleigh = std::sqrt(-4.0 / std::numbers::pi * std::log(above));  // of mean 1
        const double intensity = std::clamp(layer.intensity * (1.0 + speckle * (rayleigh - 1.0)), 0.0, 1.0);
        const double opacity = opacityAt(curve, intensity);
        alpha += opacity / shares;
        light += intensity * opacity / shares;
    }
    return {alpha > 0.0 ? light / alpha : 0.0, alpha, layer.units};
}

ModelPixels speckledPixelsOf(const TwoIntensities& model, const OpacityCurve& curve, double speckle) {
    const auto pixel = [&](ModelRay ray) {
        std::array<RayLayer, 2> layers = layersOf(model, curve, ray);
        for (RayLayer& layer : layers) layer = speckledLayer(layer, curve, speckle);
        return inClosedForm(layers, model.background);
    };
    return {pixel(ModelRay::throughFluid), pixel(ModelRay::intoTissue)};
}

}  // namespace echolucent
