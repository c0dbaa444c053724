// Intensities along straight lines through the volume, in double precision, and what a classification makes of them.
// The measures of a picture are made from these samples, slower and simpler than the ray caster makes a picture.
#pragma once

#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "processing/classification.h"
#include "processing/sampling/gradient_magnitude.h"
#include "processing/volume/volume.h"

namespace echolucent {

/// Normalised intensities at firstVoxel + i * stepVoxel (voxel index space), by trilinear interpolation of
/// VolumeSampler. NaN if VolumeSampler gives no intensity or the position lies outside the volume's box.
void sampleLine(const Volume& volume, const Vec3& firstVoxel, const Vec3& stepVoxel, std::span<double> intensities);

/// The parameters t at which pointMm + t * directionMm (grid mm) enters and leaves the volume's box; empty if the line
/// misses the box.
struct LineSpan {
    double from = 0.0, to = 0.0;
};
[[nodiscard]] std::optional<LineSpan> spanInBox(const VolumeGeometry& geometry, const Vec3& pointMm,
                                                const Vec3& directionMm);

/// Opacity per unit for the measures: a curve as 256 samples, linear between them, or a two-dimensional OTF as it is.
class OpacityTable {
public:
    explicit OpacityTable(const Classification& classification);
    /// Whether at() needs the gradient magnitude.
    [[nodiscard]] bool isTwoDimensional() const { return m_twoDimensional != nullptr; }
    /// The opacity at an intensity in [0,1]; a curve ignores the gradient magnitude.
    [[nodiscard]] double at(double intensity, double gradient) const;

private:
    std::vector<double> m_opacities;
    std::shared_ptr<const TwoDimensionalOtf> m_twoDimensional;
};
[[nodiscard]] std::vector<OpacityTable> tablesOf(std::span<const Classification> classifications);
[[nodiscard]] bool anyTwoDimensional(std::span<const OpacityTable> tables);

/// Samples along one ray, from front to back, one unit apart.
struct RaySamples {
    std::vector<double> intensities;  ///< normalised; NaN without data
    std::vector<double> gradients;    ///< gradient magnitudes at the same places; empty if not asked for
};

class RaySampler {
public:
    /// The volume must outlive the sampler. With gradient magnitudes, voxels without data beside data are filled first
    /// (filledVoxels()). That takes a few passes if the volume lacks data somewhere.
    RaySampler(const Volume& volume, bool withGradients);
    RaySampler(const RaySampler&) = delete;
    RaySampler& operator=(const RaySampler&) = delete;

    [[nodiscard]] const Volume& volume() const { return m_volume; }
    /// `count` samples at firstVoxel + i * stepVoxel.
    [[nodiscard]] RaySamples along(const Vec3& firstVoxel, const Vec3& stepVoxel, std::size_t count) const;

private:
    const Volume& m_volume;
    std::optional<Volume> m_filled;
    std::optional<GradientMagnitude> m_gradients;
};

/// Composites front to back (Petersch 2005, eq. 3), white for full intensity, on a black ground. Calls light(i,
/// contribution) for every sample with data, in order; contributions are normalised. Ends once at most
/// `leastTransmittance` comes through, and returns what still comes through, [0,1].
template <typename Light>
double compositeAlong(const RaySamples& ray, const OpacityTable& table, double leastTransmittance, const Light& light) {
    double transmittance = 1.0;
    for (std::size_t i = 0; i < ray.intensities.size() && transmittance > leastTransmittance; ++i) {
        const double intensity = ray.intensities[i];
        if (std::isnan(intensity)) continue;
        const double opacity = table.at(intensity, ray.gradients.empty() ? 0.0 : ray.gradients[i]);
        light(i, transmittance * opacity * intensity);
        transmittance *= 1.0 - opacity;
    }
    return transmittance;
}

}  // namespace echolucent
