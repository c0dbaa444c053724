// The contour spectrum: what the isosurfaces of a volume are like, over the isovalue (Bajaj, Pascucci, Schikore 1997;
// docs/designers/contour-spectrum.md).
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "processing/progress.h"
#include "processing/volume/volume.h"

namespace echolucent {

/// Of the isosurface f = w, f the normalised intensity, over `count` isovalues w from 0 to 1. All lengths are in units
/// (the smallest spacing). What is clamped to 0 or 1 is no surface: the values there stand for these voxels.
struct ContourSpectrum {
    static constexpr std::size_t count = 256;
    std::vector<double> area;              ///< A(w), units²; its integral over w is that of g over the volume
    std::vector<double> volume;            ///< V(w), units³: how much of the volume is above w; it never rises
    std::vector<double> gradientIntegral;  ///< G(w), units: the integral of g over the isosurface, g per unit

    /// w of an index: index / 255.
    [[nodiscard]] static double isovalue(std::size_t index) {
        return static_cast<double>(index) / static_cast<double>(count - 1);
    }
    /// How much of the axis of w an index stands for, so that sums over it are integrals: 1 / 255, at both ends half.
    [[nodiscard]] static double width(std::size_t index) {
        return (index == 0 || index + 1 == count ? 0.5 : 1.0) / static_cast<double>(count - 1);
    }
    /// G / A, per unit; NaN where there is no area.
    [[nodiscard]] std::vector<double> meanGradient() const;
};

/// By the coarea formula: A(w) is the sum of g dV, G(w) that of g² dV over the voxels with data whose intensities are
/// about w, divided by the width of that range. g is GradientMagnitude, so that the end of the data is no surface, and
/// dV a voxel's volume. A voxel counts for all intensities that it spans: those within g / 2 times its edge of its own,
/// at least half a step. The result is empty only where progress.cancel was raised, and has the same bits for any
/// number of threads. Voxels that are not finite are no data.
[[nodiscard]] std::optional<ContourSpectrum> contourSpectrum(const Volume& volume, const Progress& progress = {});

/// An isovalue at which isosurfaces are steeper than those beside it.
struct SpectrumMaximum {
    std::size_t index = 0;      ///< into the spectrum's vectors
    double isovalue = 0.0;      ///< ]0,1[
    double area = 0.0;          ///< units², of the spectrum
    double meanGradient = 0.0;  ///< per unit, after smoothing
};

/// The maxima of the mean gradient, steepest first. Area and gradient integral are smoothed over w before they are
/// divided. Only isovalues whose area is at least `leastArea` of the largest one, [0,1], take part, because the mean
/// gradient of the few voxels at rare intensities is noise and often large; and a maximum counts where the mean
/// gradient falls on both sides by at least a twentieth of it, within these isovalues, before it rises above it.
[[nodiscard]] std::vector<SpectrumMaximum> maximaOf(const ContourSpectrum& spectrum, double leastArea);

}  // namespace echolucent
