#include "processing/designers/gradients/histogram_volume.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>

#include "processing/designers/gradients/normal_derivatives.h"
#include "processing/parallel.h"
#include "processing/sampling/gradient_magnitude.h"
#include "processing/volume/filled_volume.h"

namespace echolucent {

namespace {

constexpr std::int64_t slabVoxels = std::int64_t{1} << 21, leastSlabSlices = 8;

/// Sums of the slices of one loop body. They are added in one order afterwards.
struct Part {
    std::vector<DerivativeSums> overIntensity, overBoth;
    std::uint64_t dataVoxels = 0, usedVoxels = 0;
    std::vector<float> pictureGradients;  ///< of a row
};

std::size_t nearestNode(double value, double largest, int count) {
    const double node = std::clamp(value / largest, 0.0, 1.0) * (count - 1);
    return static_cast<std::size_t>(std::lround(node));
}

/// Gradient magnitudes as pictures read them.
struct PictureGradients {
    explicit PictureGradients(const Volume& volume) : filled(filledVoxels(volume)), magnitudes(filled) {}
    PictureGradients(const PictureGradients&) = delete;
    PictureGradients& operator=(const PictureGradients&) = delete;

    Volume filled;
    GradientMagnitude magnitudes;
    double largest = 1.0;
};

class Accumulation {
public:
    Accumulation(const Volume& volume, const NormalDerivativeSlices& derivatives, const PictureGradients* pictures,
                 int gradients)
        : m_volume(volume), m_derivatives(derivatives), m_pictures(pictures), m_gradients(gradients) {}

    [[nodiscard]] Part emptyPart() const {
        Part part;
        part.overIntensity.resize(HistogramVolume::intensityNodes);
        if (m_pictures == nullptr) return part;
        part.overBoth.resize(static_cast<std::size_t>(HistogramVolume::intensityNodes) *
                             static_cast<std::size_t>(m_gradients));
        part.pictureGradients.resize(static_cast<std::size_t>(m_volume.geometry().size[0]));
        return part;
    }

    void addSlice(std::int64_t z, Part& part) const {
        for (std::int64_t y = 0; y < m_volume.geometry().size[1]; ++y) addRow(y, z, part);
    }

private:
    void addRow(std::int64_t y, std::int64_t z, Part& part) const {
        const VolumeGeometry& geometry = m_volume.geometry();
        const std::span<const float> intensities = m_derivatives.intensities(y, z);
        if (m_pictures != nullptr) m_pictures->magnitudes.row(y, z, part.pictureGradients);
        for (std::int64_t x = 0; x < geometry.size[0]; ++x) {
            if (!m_volume.hasData(geometry.offset(x, y, z))) continue;
            ++part.dataVoxels;
            if (!m_derivatives.knownAt(x, y, z)) continue;
            ++part.usedVoxels;
            const NormalDerivatives here = m_derivatives.at(x, y, z);
            const DerivativeSums sums{1.0, here.intensity, here.gradient, here.second};
            part.overIntensity[nearestNode(here.intensity, 1.0, HistogramVolume::intensityNodes)] += sums;
            if (m_pictures == nullptr) continue;
            const auto column = static_cast<std::size_t>(x);
            const std::size_t row = nearestNode(part.pictureGradients[column], m_pictures->largest, m_gradients);
            part.overBoth[row * HistogramVolume::intensityNodes +
                          nearestNode(intensities[column], 1.0, HistogramVolume::intensityNodes)] += sums;
        }
    }

    const Volume& m_volume;
    const NormalDerivativeSlices& m_derivatives;
    const PictureGradients* m_pictures;  ///< null if not asked for
    int m_gradients;
};

void requireValid(const HistogramVolumeConfig& config) {
    if (!(config.prefilter >= 0.0 && config.prefilter <= 8.0))
        throw std::invalid_argument("HistogramVolumeConfig: the prefilter must be 0 to 8");
    if (config.gradients != 0 && (config.gradients < 2 || config.gradients > 1024))
        throw std::invalid_argument("HistogramVolumeConfig: the gradients must be 0 or 2 to 1024");
}

HistogramVolume joined(const std::vector<Part>& parts) {
    HistogramVolume result;
    for (const Part& part : parts) {
        const auto add = [](std::vector<DerivativeSums>& to, const std::vector<DerivativeSums>& from) {
            to.resize(from.size());
            for (std::size_t i = 0; i < from.size(); ++i) to[i] += from[i];
        };
        add(result.overIntensity, part.overIntensity);
        add(result.overBoth, part.overBoth);
        result.dataVoxels += part.dataVoxels;
        result.usedVoxels += part.usedVoxels;
    }
    return result;
}

}  // namespace

DerivativeSums& DerivativeSums::operator+=(const DerivativeSums& other) {
    voxels += other.voxels;
    intensities += other.intensities;
    gradients += other.gradients;
    seconds += other.seconds;
    return *this;
}

std::optional<HistogramVolume> histogramVolume(const Volume& volume, const HistogramVolumeConfig& config,
                                               const Progress& progress) {
    requireValid(config);
    std::optional<PictureGradients> pictures;
    if (config.gradients > 0) {
        pictures.emplace(volume);
        const std::optional<GradientRange> range = gradientRange(volume, pictures->filled, progress);
        if (!range) return std::nullopt;
        if (range->largest > 0.0) pictures->largest = range->largest;
    }
    NormalDerivativeSlices derivatives(volume, config.prefilter);
    const Accumulation accumulation(volume, derivatives, pictures ? &*pictures : nullptr, config.gradients);
    // The slices of a part and their order do not depend on the number of threads.
    constexpr std::int64_t partCount = 16;
    std::vector<Part> parts(partCount, accumulation.emptyPart());
    const std::int64_t slices = volume.geometry().size[2], slice = volume.geometry().offset(0, 0, 1);
    const std::int64_t slab = std::max(leastSlabSlices, slabVoxels / slice);
    for (std::int64_t first = 0; first < slices; first += slab) {
        const std::int64_t end = std::min(slices, first + slab);
        if (!derivatives.make(first, end, progress)) return std::nullopt;
        parallelFor<std::int64_t>(0, partCount, [&](std::int64_t part) {
            const std::int64_t behind = (part - first % partCount + partCount) % partCount;
            for (std::int64_t z = first + behind; z < end && !progress.cancelled(); z += partCount)
                accumulation.addSlice(z, parts[static_cast<std::size_t>(part)]);
        });
        if (progress.cancelled()) return std::nullopt;
        progress.at(static_cast<double>(end) / static_cast<double>(slices));
    }
    HistogramVolume result = joined(parts);
    result.gradientNodes = config.gradients;
    if (pictures) result.largestGradient = pictures->largest;
    return result;
}

}  // namespace echolucent
