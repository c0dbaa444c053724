// The contour spectrum: size and steepness of a volume's isosurfaces over the isovalue (Bajaj, Pascucci, Schikore 1997;
// docs/designers/contour-spectrum.md).
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "processing/progress.h"
#include "processing/volume/volume.h"

namespace echolucent {

/// Figures of the isosurface f = w, f the normalised intensity, over `count` isovalues w from 0 to 1. Lengths are in
/// units (the smallest spacing). The values at 0 and 1 are of clamped voxels, which are no surface.
struct ContourSpectrum {
    static constexpr std::size_t count = 256;
    std::vector<double> area;              ///< A(w), units²; its integral over w is that of g over the volume
    std::vector<double> volume;            ///< V(w), units³: the part of the volume above w; it never rises
    std::vector<double> gradientIntegral;  ///< G(w), units: the integral of g over the isosurface, g per unit

    /// w of an index: index / 255.
    [[nodiscard]] static double isovalue(std::size_t index) {
        return static_cast<double>(index) / static_cast<double>(count - 1);
    }
    /// The part of the axis of w that belongs to an index, so that sums over it are integrals: 1 / 255, half of it at
    /// both ends.
    [[nodiscard]] static double width(std::size_t index) {
        return (index == 0 || index + 1 == count ? 0.5 : 1.0) / static_cast<double>(count - 1);
    }
    /// G / A, per unit; NaN without area.
    [[nodiscard]] std::vector<double> meanGradient() const;
};

/// Uses the coarea formula. A(w) is the sum of g dV, and G(w) that of g² dV, over the voxels with data whose
/// intensities are about w, divided by the width of that range. g is GradientMagnitude, so that the end of the data is
/// no surface. dV is a voxel's volume. A voxel counts for all intensities that it spans: up to g / 2 times its edge
/// from its own, at least half a step. The result is empty only if progress.cancel was raised. Its bits are the same
/// for any number of threads. Voxels that are not finite are no data.
[[nodiscard]] std::optional<ContourSpectrum> contourSpectrum(const Volume& volume, const Progress& progress = {});

/// An isovalue whose isosurfaces are steeper than those beside it.
struct SpectrumMaximum {
    std::size_t index = 0;      ///< into the spectrum's vectors
    double isovalue = 0.0;      ///< ]0,1[
    double area = 0.0;          ///< units², of the spectrum
    double meanGradient = 0.0;  ///< per unit, after smoothing
};

/// The maxima of the mean gradient, steepest first. Area and gradient integral are smoothed over w before the division.
/// Isovalues count only if their area is at least `leastArea` of the largest, [0,1]: at rare intensities the mean
/// gradient of a few voxels is noise and often large. A maximum counts if, on both sides and within these isovalues,
/// the mean gradient falls by at least a twentieth of the maximum before it rises above the maximum. Of a plateau, the
/// first isovalue counts.
[[nodiscard]] std::vector<SpectrumMaximum> maximaOf(const ContourSpectrum& spectrum, double leastArea);

}  // namespace echolucent
