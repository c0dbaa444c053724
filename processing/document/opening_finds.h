// What is found of a volume when it is opened: which way round it is, and where to cut.
#pragma once

#include <optional>

#include "processing/beam/beam_guess.h"
#include "processing/document/document.h"
#include "processing/near_cut.h"
#include "processing/progress.h"
#include "processing/volume/volume.h"

namespace echolucent {

/// Each with its own confidence.
struct OpeningFinds {
    BeamGuess beam;
    ViewDirection lean{};                 ///< of the beam against its axis, where the file says so
    std::optional<NearCutFinding> cut{};  ///< looked for along a sure beam only: nobody cuts along another
};

/// Looks at a volume that was read from a file, the first phase of a study. The result is empty only where it was
/// cancelled.
[[nodiscard]] std::optional<OpeningFinds> findOnOpening(const Volume& volume, const Progress& progress = {});

/// The document with the finds that are sure: the beam, and along a sure beam the flat cut (rounded to 0.1 mm, as
/// people set it). Tube cores look along the beam; poses stay as they are. What is not sure stays as it is.
[[nodiscard]] Document withFinds(Document document, const OpeningFinds& finds);

}  // namespace echolucent
