// What the tube cores say of quiet voxels: where the picture is taken from voxels with less speckle than those on which
// the surfaces were found, the curve is meant for the quiet ones.
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

/// The voxels that the picture is taken from.
struct QuietVoxels {
    const Volume* volume = nullptr;  ///< null: those in which the surfaces are found
    SpeckleReduction reduction = SpeckleReduction::off;
};

/// What the curve is to be made of.
struct QuietReading {
    std::vector<TubeCore>
        tubes;                 ///< surfaces and weights as found; I_L, I_H and the fluid's spread of the quiet voxels
    CurveRule curve;           ///< for the quiet voxels, see quieterRule()
    double speckleLeft = 1.0;  ///< the fluid's spread in the quiet voxels over that in those read, [0,1]: means
                               ///< weighted by d; 1 where the detection measures no spread
};

/// Reads the quiet voxels along the same samples, at the surfaces that were found in the voxels as they were read. The
/// result is empty only where the run was cancelled.
[[nodiscard]] std::optional<QuietReading> readQuiet(const Volume& quiet, const AdaptiveOtfConfig& config,
                                                    std::span<const TubeSamples> samples,
                                                    std::span<const TubeCore> tubes, const Progress& progress);

/// The rule where this share of the speckle is left. What is quiet needs no ramp that tells speckle from surface by
/// being flat: it begins later, above haze and partial volume, and is full sooner. With all speckle left it is the rule
/// itself. The product of basis functions stays as it is.
[[nodiscard]] CurveRule quieterRule(const CurveRule& rule, double speckleLeft);

}  // namespace echolucent
