// The import report as a person reads it: what the reader says, and which way sound travelled.
#pragma once

#include <string>
#include <vector>

#include "io/study/study.h"
#include "processing/beam/beam_guess.h"

namespace echolucent {

/// The facts of a study, followed by its beam axis and why that was taken. Where the file says where the probe was, the
/// facts hold the beam already.
[[nodiscard]] std::vector<ImportFact> importReport(const Study& study, const BeamGuess& beam);

/// What is to be said before a picture or movie of the study is saved: that it may show names, where its pictures are
/// not free of text drawn into them. An empty text where they are.
[[nodiscard]] std::string burnedInTextNote(const Study& study);

}  // namespace echolucent
