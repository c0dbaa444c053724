// What one tube core found, and what it does to the curve, as one HTML page.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "processing/adaptive/adaptive_otf_result.h"
#include "processing/explanation/tube_explanation.h"
#include "processing/picture/lighting.h"
#include "processing/picture/picture.h"

namespace echolucent {

/// What the page holds beside the explanation. Names in it are as they may be shown.
struct ExplanationPage {
    std::string scan;     ///< the scan's name or number; empty: none is said
    std::string program;  ///< name and version
    /// Pictures with their captions: of all tube cores, without this one, of it alone. May be empty.
    std::vector<std::pair<Picture, std::string>> pictures{};
    Lighting lighting = Lighting::flat;  ///< of the pictures
    int phase = 0, phases = 1;           ///< whose tube core it is, counted from 0, of how many
};

/// The file. It needs no other one and no network. `otf` is the run that was explained.
[[nodiscard]] std::string explanationPage(const ExplanationPage& page, const TubeExplanation& explanation,
                                          const AdaptiveOtf& otf);

}  // namespace echolucent
