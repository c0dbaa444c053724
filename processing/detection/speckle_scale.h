// A scale of intensity on which the data's own speckle is equally strong everywhere (a variance-stabilising transform).
// A difference on it means the same in fluid and in tissue, before and after logarithmic compression.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "processing/tube_core/slabs/tube_profiles.h"

namespace echolucent {

/// How far speckle spreads the voxels around a mean intensity, and the scale that follows: the integral of 1 / spread.
/// If the spread grows with the mean (raw echo), the scale is a logarithm, and a difference on it is a ratio of
/// intensities. If the spread is constant (compressed echo), the scale is the intensity itself. Scanners deliver
/// something between. One unit of the scale is one standard deviation of the voxels of a slab.
class SpeckleScale {
public:
    /// Measures the spread on the tubes' slabs: its median among slabs of like mean. The median ignores slabs with a
    /// boundary in them.
    explicit SpeckleScale(const TubeProfiles& profiles);

    /// Standard deviation of voxels around this mean, normalised intensity, above 0.
    [[nodiscard]] double spreadAt(double intensity) const;
    /// How bright the view is: nearly all slabs stay below about this mean intensity. 0 without slabs.
    [[nodiscard]] double brightMean() const { return m_brightMean; }
    /// A normalised intensity in [0,1] on the scale; 0 at 0, rising.
    [[nodiscard]] double scaled(double intensity) const;
    /// scaled() for many intensities; `results` is as long as `intensities`.
    void scale(std::span<const float> intensities, std::span<float> results) const;
    /// The intensity at a value of the scale, clamped into [0,1].
    [[nodiscard]] double intensityAt(double scaled) const;

private:
    static constexpr int sampleCount = 1025;
    std::array<double, sampleCount> m_spread{}, m_scaled{};
    double m_brightMean = 0.0;
};

}  // namespace echolucent
