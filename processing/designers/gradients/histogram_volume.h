// The histogram volume of Kindlmann and Durkin (1998), reduced to the sums from which its means are made.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "processing/progress.h"
#include "processing/volume/volume.h"

namespace echolucent {

struct HistogramVolumeConfig {
    /// Standard deviation of the Gaussian under which derivatives are taken, units, [0,8]. 0: no Gaussian.
    double prefilter = 1.0;
    /// Nodes over the gradient magnitude, 2 to 1024. 0: no HistogramVolume::overBoth.
    int gradients = 0;
};

/// Sums over the voxels of a bin.
struct DerivativeSums {
    double voxels = 0.0;       ///< how many
    double intensities = 0.0;  ///< sum of f under the Gaussian, normalised intensity
    double gradients = 0.0;    ///< sum of g under the Gaussian, normalised intensity per unit
    double seconds = 0.0;      ///< sum of h under the Gaussian, normalised intensity per square unit

    DerivativeSums& operator+=(const DerivativeSums& other);
    friend bool operator==(const DerivativeSums&, const DerivativeSums&) = default;
};

/// The histogram volume over the intensity f, the gradient magnitude g and the second derivative along the gradient h
/// (Kindlmann and Durkin 1998, section 4). The method needs only means: of g and h at an intensity, and of h at an
/// intensity and a gradient magnitude. So it keeps sums instead of bins over h, and the means are exact.
///
/// g is the length of central differences. h is the Laplacian less the part that the boundary's curvature makes:
/// h = div grad f - g div(grad f / g), by central differences of the unit gradient (docs/designers/kindlmann.md,
/// "Derivatives", compares it with others). Both are per unit, the smallest spacing.
///
/// A voxel counts if it carries data and enough around it was scanned: the voxels that its derivatives use, up to two
/// along each axis, and samples at this distance plus the Gaussian's standard deviation. A Gaussian that is cut off
/// would bend an even intensity, and the end of the data is no boundary of tissue. An axis too short for that has no
/// derivative.
struct HistogramVolume {
    static constexpr int intensityNodes = 256;

    /// Over f under the Gaussian: each voxel at the nearest intensity i / (intensityNodes - 1).
    std::vector<DerivativeSums> overIntensity;
    /// Over f and g as pictures read them, without the Gaussian (GradientMagnitude), at the nearest node of a
    /// TwoDimensionalOtf: index = node of g * intensityNodes + node of f. The sums are of derivatives under the
    /// Gaussian.
    std::vector<DerivativeSums> overBoth;
    int gradientNodes = 0;         ///< over g in overBoth; 0 if it is empty
    double largestGradient = 1.0;  ///< g of the last node, normalised intensity per unit, above 0
    std::uint64_t dataVoxels = 0;  ///< that carry data
    std::uint64_t usedVoxels = 0;  ///< of these, those that count
};

/// The result is empty only if progress.cancel was raised. Its bits are the same for any number of threads. Besides the
/// result it takes about 24 bytes for each voxel of a slab of 2^21 voxels (at least eight slices); for overBoth also a
/// copy of the volume, if voxels lack data (filledVoxels()). Throws std::invalid_argument if a member of the config is
/// out of its range.
[[nodiscard]] std::optional<HistogramVolume> histogramVolume(const Volume& volume, const HistogramVolumeConfig& config,
                                                             const Progress& progress = {});

}  // namespace echolucent
