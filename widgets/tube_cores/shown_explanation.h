// What the panel *Tube cores* shows of an explanation: all texts and plots, made in the thread that explains.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "processing/explanation/explanation_facts.h"
#include "processing/explanation/tube_explanation.h"
#include "processing/plots/plot.h"

namespace echolucent {

struct ShownExplanation {
    std::shared_ptr<const AdaptiveOtf> run;  ///< whose tube core it is
    std::shared_ptr<const TubeExplanation> explanation;
    std::string sentence;  ///< explanationSentence()
    std::vector<ExplanationFact> facts;
    Plot profile, interfaceFunction, factors;
    std::array<Plot, 2> ranks;  ///< by the largest prior mean, by the slope
    Plot curves;                ///< without the curve that grows
    Plot change;                ///< of the curve without the tube core from the run's
    int weighing = 0;           ///< how many tube cores have a weight
};

}  // namespace echolucent
