// The import report as a person reads it: what the reader says, and the direction of sound.
#pragma once

#include <string>
#include <vector>

#include "io/study/study.h"
#include "processing/beam/beam_guess.h"

namespace echolucent {

/// The facts of a study, followed by its beam axis and why that was taken. If the file states the place of the probe,
/// the facts hold the beam already.
[[nodiscard]] std::vector<ImportFact> importReport(const Study& study, const BeamGuess& beam);

/// What to tell a person before a picture or movie of the study is saved: that it may show names, if the study's
/// pictures may have text drawn into them. Empty if they are free of text.
[[nodiscard]] std::string burnedInTextNote(const Study& study);

}  // namespace echolucent
