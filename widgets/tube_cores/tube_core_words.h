// What map and list say of the tube cores of a run.
#pragma once

#include <QString>
#include <vector>

#include "processing/explanation/tube_explanation.h"

namespace echolucent {

/// The tube cores of a run by number; empty without a run.
struct TubeCoreStates {
    explicit TubeCoreStates(const AdaptiveOtf* run = nullptr);
    std::vector<TubeState> states;
    std::vector<double> shares;  ///< d over the largest d, [0,1]; 0 if no tube core has a weight
};

/// nameOf(state).
[[nodiscard]] QString wordsOf(TubeState state);

/// "Tube core 112: column 7, row 7, weighs, d 0.021".
[[nodiscard]] QString lineOf(const AdaptiveOtf& run, int number);

}  // namespace echolucent
