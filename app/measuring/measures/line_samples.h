// These are intensities along straight lines through the volume, in double. The measures of a picture are made from
// them; they are slower and plainer than the ray caster.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "processing/opacity_curve.h"
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

/// Opacity per unit as 256 samples of a curve, linear between them. The measures composite with it.
class OpacityTable {
public:
    explicit OpacityTable(const OpacityCurve& curve);
    /// The opacity at an intensity in [0,1].
    [[nodiscard]] double at(double intensity) const;

private:
    std::vector<double> m_opacities;
};

}  // namespace echolucent
