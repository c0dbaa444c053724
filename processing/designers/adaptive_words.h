// What a run of the adaptive method did, in sentences. Designs and the window say them.
#pragma once

#include <string>

#include "processing/adaptive/adaptive_otf_result.h"

namespace echolucent {

/// Whether tube cores made the curve. Otherwise it is the initial function, and AdaptiveOtf::message says why.
[[nodiscard]] bool tubeCoresMadeTheCurve(const AdaptiveOtf& otf);

/// How many surfaces were found, and the mean intensities before and at them. Needs tubeCoresMadeTheCurve().
[[nodiscard]] std::string surfaceSentence(const AdaptiveOtf& otf);
/// What of its tube core counts as a surface.
[[nodiscard]] std::string detectionSentence(const AdaptiveOtfConfig& config);
/// How the curve follows from the tube cores. Needs tubeCoresMadeTheCurve().
[[nodiscard]] std::string curveSentence(const AdaptiveOtf& otf);
/// In which voxels surfaces and intensities were read. Empty if the curve is meant for the voxels as they were read.
[[nodiscard]] std::string voxelsSentence(const AdaptiveOtf& otf);
/// The reading of the paper that the run followed. Says what in it is not the paper's.
[[nodiscard]] std::string readingSentence(const AdaptiveOtf& otf);

}  // namespace echolucent
