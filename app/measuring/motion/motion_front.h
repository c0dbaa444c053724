// What a motion does to the OTF if the front is fixed in the volume, and if it turns along with the view.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "app/measuring/motion/motion_measure.h"

namespace echolucent::cli {

/// How the front of a motion's frames and d_max of their OTFs are chosen.
enum class FrontOfFrames {
    fixed,           ///< the front of the start view, fixed in the volume
    turns,           ///< across each frame's view, as deep as in the start view: so it was in 0.1
    fixedStartDMax,  ///< fixed, and d_max is that of the start view in every frame; of the product only
};
/// "fixed", "turns along", "fixed, d_max of the start view".
[[nodiscard]] std::string nameOf(FrontOfFrames front);

/// The course of a motion of the probe with one choice of the front.
struct FrontFigures {
    std::string name;  ///< of the case
    FrontOfFrames front = FrontOfFrames::fixed;
    int leastTubes = 0, mostTubes = 0;        ///< tube cores that meet data, over the frames
    int leastSurfaces = 0, mostSurfaces = 0;  ///< tube cores with a weight, over the frames
    double leastSumOfD = 0.0, mostSumOfD = 0.0;
    double flicker = 0.0, flickerLeft = 0.0;  ///< of the OTFs, unsmoothed and after leastFlicker
    std::array<double, 3> rms{};              ///< between the OTFs of first and middle, middle and last, first and last
};

/// The figures with each choice of the front. Empty if the probe does not move, or if the start view has no flat front.
[[nodiscard]] std::vector<FrontFigures> measureFront(const MotionCase& motionCase, const AdaptiveOtfConfig& config);
/// A row for each case and choice.
[[nodiscard]] std::string motionFrontTable(const std::vector<FrontFigures>& figures);

}  // namespace echolucent::cli
