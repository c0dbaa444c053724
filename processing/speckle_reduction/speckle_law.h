// The strength of speckle at each intensity, measured on the volume itself.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "processing/speckle_reduction/filter_slabs.h"
#include "processing/volume/volume.h"

namespace echolucent {

/// The spread of speckle follows a power of the intensity: factor * (intensity + offset)^exponent. The exponent is 1
/// for raw echo (Rayleigh) and 0 after logarithmic compression. Scanners deliver something between (Coupe et al. 2009,
/// there gamma, 0.5).
struct SpeckleLaw {
    static constexpr double offset = 2.0 / 255.0;  ///< the darkest voxels are rounded; normalised intensity
    double factor = 0.01;                          ///< above 0
    double exponent = 0.0;                         ///< [0,1]

    /// Standard deviation at a normalised intensity.
    [[nodiscard]] double spreadAt(double intensity) const;
    /// A normalised intensity on a scale on which speckle is equally strong everywhere: an integral of 1 / spread, in
    /// standard deviations. Only differences of two results have a meaning.
    [[nodiscard]] double scaled(double intensity) const;
};

/// Measures the law on pairs of voxels a few mean voxels apart (filterSpacing()). So far apart, two voxels share no
/// speckle but mostly lie in one tissue. The law follows the medians of their differences at like intensities. The law
/// is the same for any cut of the volume into slabs.
class SpeckleLawMeasurement {
public:
    /// The grid of the whole volume.
    explicit SpeckleLawMeasurement(VolumeGeometry geometry);
    /// The most slices between a slab's end and a pair's second voxel.
    [[nodiscard]] std::int64_t reach() const;
    /// Takes the pairs with their first voxel in the slices of a slab. `held` are the voxels that the slab holds.
    void add(const Volume& held, const FilterSlab& slab);
    /// The law of the pairs taken so far; the default SpeckleLaw if no intensity has enough pairs.
    [[nodiscard]] SpeckleLaw law();

private:
    static constexpr int intensityBins = 64;
    [[nodiscard]] std::int64_t placesAlong(int axis) const;

    VolumeGeometry m_geometry;
    Vec3 m_spacing;
    std::array<std::vector<double>, intensityBins> m_differences;  // of the pairs of each intensity
};

}  // namespace echolucent
