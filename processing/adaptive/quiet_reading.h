// Reads tube cores in quiet voxels. The picture may show voxels with less speckle than those in which the surfaces were
// found. The curve is then meant for the quiet voxels.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "processing/adaptive/adaptive_otf_config.h"
#include "processing/progress.h"
#include "processing/speckle_reduction/speckle_reduction.h"
#include "processing/tube_core/slabs/tube_samples.h"
#include "processing/tube_core/tube_core.h"

namespace echolucent {

/// The voxels that the picture shows.
struct QuietVoxels {
    /// If null, or if `reduction` is off, the picture shows the voxels in which the surfaces are found.
    const Volume* volume = nullptr;
    SpeckleReduction reduction = SpeckleReduction::off;
};

/// What the curve is made from.
struct QuietReading {
    std::vector<TubeCore>
        tubes;  ///< surfaces and weights as found; what readSurface() reads and the fluid's spread are of the quiet
                ///< voxels, unless a tube core has no weight or the quiet voxels show no rise
    CurveRule curve;  ///< for the quiet voxels, see quieterRule()
    /// The fluid's spread in the quiet voxels over that in the voxels read, [0,1]: means weighted by d. No value if no
    /// spread was measured, as with VarianceRule.
    std::optional<double> speckleLeft{};
};

/// Reads the quiet voxels along the same samples, at the surfaces already found. The result is empty only if the work
/// was cancelled.
[[nodiscard]] std::optional<QuietReading> readQuiet(const Volume& quiet, const AdaptiveOtfConfig& config,
                                                    std::span<const TubeSamples> samples,
                                                    std::span<const TubeCore> tubes, const Progress& progress);

/// The rule for voxels in which the share `speckleLeft` of the speckle is left. A ramp rises gently to tell speckle
/// from surface, and quiet voxels need no such ramp. So their ramp begins later, above haze and partial volume, and is
/// full sooner. The rule stays as it is if all speckle is left, and always if it is a ProductRule.
[[nodiscard]] CurveRule quieterRule(const CurveRule& rule, double speckleLeft);

}  // namespace echolucent
