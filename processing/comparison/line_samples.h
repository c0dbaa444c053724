// These are intensities along straight lines through the volume, in double, and what a classification makes of them.
// The measures of a picture are made from them; they are slower and plainer than the ray caster.
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

/// Normalised intensities at firstVoxel + i * stepVoxel (voxel index space) as VolumeSampler takes them by trilinear
/// interpolation; NaN where it gives none or the position lies outside the volume's box.
void sampleLine(const Volume& volume, const Vec3& firstVoxel, const Vec3& stepVoxel, std::span<double> intensities);

/// Where a line is within the volume's box: the parameters of pointMm + t * directionMm (grid mm) at which it enters
/// and leaves it; nothing where it misses the box.
struct LineSpan {
    double from = 0.0, to = 0.0;
};
[[nodiscard]] std::optional<LineSpan> spanInBox(const VolumeGeometry& geometry, const Vec3& pointMm,
                                                const Vec3& directionMm);

/// Opacity per unit: a curve as 256 samples, linear between them, or a two-dimensional OTF as it is. The measures
/// composite with it.
class OpacityTable {
public:
    explicit OpacityTable(const Classification& classification);
    /// Whether it asks the gradient magnitude.
    [[nodiscard]] bool isTwoDimensional() const { return m_twoDimensional != nullptr; }
    /// The opacity at an intensity in [0,1]; a curve does not look at the gradient magnitude.
    [[nodiscard]] double at(double intensity, double gradient) const;

private:
    std::vector<double> m_opacities;
    std::shared_ptr<const TwoDimensionalOtf> m_twoDimensional;
};
[[nodiscard]] std::vector<OpacityTable> tablesOf(std::span<const Classification> classifications);
[[nodiscard]] bool anyTwoDimensional(std::span<const OpacityTable> tables);

/// What is read along one ray, from front to back, one unit apart.
struct RaySamples {
    std::vector<double> intensities;  ///< normalised; NaN where there is no data
    std::vector<double> gradients;    ///< gradient magnitudes of the same places, or empty where none were asked for
};

/// Reads rays of one volume.
class RaySampler {
public:
    /// The volume must outlive it. Where gradient magnitudes are asked for, voxels without data beside data are filled
    /// first (filledVoxels()), which takes a few passes over a volume that lacks data somewhere.
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

/// Composites front to back (Petersch 2005, eq. 3) with white for full intensity on a black ground: calls light(i,
/// contribution) for every sample with data, in order. Contributions are normalised. It ends where no more than
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
