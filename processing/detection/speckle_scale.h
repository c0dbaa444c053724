// A scale of intensity on which the data's own speckle is equally strong everywhere (a variance-stabilising transform):
// on it a difference means the same in fluid and in tissue, before and after logarithmic compression.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "processing/tube_core/slabs/tube_profiles.h"

namespace echolucent {

/// How far speckle spreads the voxels around a mean intensity, and the scale that follows from it: the integral of
/// 1 / spread. Where the spread grows with the mean (raw echo) it is a logarithm, so that a difference on it is a
/// ratio of intensities; where the spread is constant (compressed echo) it is the intensity itself; what scanners
/// deliver lies between. One unit of the scale is one standard deviation of the voxels of a slab.
class SpeckleScale {
public:
    /// Measures the spread on the tubes' slabs: its median among slabs of like mean. A boundary in a slab is an outlier
    /// the median does not see.
    explicit SpeckleScale(const TubeProfiles& profiles);

    /// Standard deviation of voxels around this mean, normalised intensity, above 0.
    [[nodiscard]] double spreadAt(double intensity) const;
    /// The mean intensity that nearly all slabs stay below: how bright the view is.
    [[nodiscard]] double brightMean() const { return m_brightMean; }
    /// A normalised intensity in [0,1] on the scale: 0 at 0, rising.
    [[nodiscard]] double scaled(double intensity) const;
    /// Many at once; as many results as intensities.
    void scale(std::span<const float> intensities, std::span<float> results) const;
    /// The intensity at a value of the scale, clamped into [0,1].
    [[nodiscard]] double intensityAt(double scaled) const;

private:
    static constexpr int sampleCount = 1025;
    std::array<double, sampleCount> m_spread{}, m_scaled{};
    double m_brightMean = 0.0;
};

}  // namespace echolucent
