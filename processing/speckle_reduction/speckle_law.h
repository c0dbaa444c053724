// How strong speckle is at an intensity, measured on the volume itself.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "processing/speckle_reduction/filter_slabs.h"
#include "processing/volume/volume.h"

namespace echolucent {

/// The spread of speckle follows a power of the intensity: factor * (intensity + offset)^exponent. The exponent is 1
/// for echo as it comes (Rayleigh), 0 after logarithmic compression, between in what scanners deliver (Coupe et al.
/// 2009, there gamma, 0.5).
struct SpeckleLaw {
    static constexpr double offset = 2.0 / 255.0;  ///< the darkest voxels are rounded; normalised intensity
    double factor = 0.01;                          ///< above 0
    double exponent = 0.0;                         ///< [0,1]

    /// Standard deviation at a normalised intensity.
    [[nodiscard]] double spreadAt(double intensity) const;
    /// A normalised intensity on a scale on which speckle is equally strong everywhere, in standard deviations: the
    /// integral of 1 / spread.
    [[nodiscard]] double scaled(double intensity) const;
};

/// Measures the law on pairs of voxels that are a few mean voxels apart (filterSpacing()), too far for one speckle, and
/// mostly of one tissue: medians of their differences at like intensities. It is the same for the same volume, however
/// that is cut into slabs.
class SpeckleLawMeasurement {
public:
    /// The grid of the whole volume.
    explicit SpeckleLawMeasurement(VolumeGeometry geometry);
    /// How many slices behind a slab's own a pair's second voxel lies, at most.
    [[nodiscard]] std::int64_t reach() const;
    /// Takes the pairs whose first voxel lies in the slices of a slab; `held` are the voxels of those that it holds.
    void add(const Volume& held, const FilterSlab& slab);
    /// The law of the pairs taken so far; without any, the law that SpeckleLaw begins with.
    [[nodiscard]] SpeckleLaw law();

private:
    static constexpr int intensityBins = 64;
    [[nodiscard]] std::int64_t placesAlong(int axis) const;

    VolumeGeometry m_geometry;
    Vec3 m_spacing;
    std::array<std::vector<double>, intensityBins> m_differences;  // of the pairs of like intensities
};

/// The law of a volume that is taken at once.
[[nodiscard]] SpeckleLaw speckleLawOf(const Volume& volume);

}  // namespace echolucent
