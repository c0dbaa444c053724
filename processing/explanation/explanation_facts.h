// An explanation as rows of a table: each symbol with its value, its equation and its place in the paper.
#pragma once

#include <string>
#include <vector>

#include "processing/explanation/tube_explanation.h"

namespace echolucent {

/// One row. Window, page and JSON show the same texts.
struct ExplanationFact {
    std::string key;       ///< name in JSON, e.g. "i_low"; each once
    std::string symbol;    ///< e.g. "I_L"
    std::string value;     ///< a number or a word, e.g. "0.097"; "none" if there is none
    std::string unit;      ///< e.g. "units"; empty for intensities, weights and counts
    std::string meaning;   ///< one sentence
    std::string equation;  ///< e.g. "d = d_max w_I w_S", or empty
    std::string place;     ///< its source: "Petersch 2005, eq. 11"
};

/// The rows, in the order in which the method finds them. Which rows there are depends on the rules and on whether the
/// curve is meant for quiet voxels, never on what a tube core found.
[[nodiscard]] std::vector<ExplanationFact> explanationFacts(const TubeExplanation& explanation);

/// What became of the tube core, as one or two sentences: "It weighs 0.021 of 0.030." or why it has no surface or no
/// weight.
[[nodiscard]] std::string explanationSentence(const TubeExplanation& explanation);

}  // namespace echolucent
