// What is found of a volume when it is opened, which way round it is and where to cut, and the document that begins
// with it.
#pragma once

#include <optional>

#include "processing/beam/beam_guess.h"
#include "processing/document/document.h"
#include "processing/near_cut/near_cut.h"
#include "processing/progress.h"
#include "processing/volume/volume.h"

namespace echolucent {

/// What a person has said of a study that is opened. It is taken, and not looked for.
struct SaidOnOpening {
    std::optional<BeamAxis> beam{};
    std::optional<ViewDirection> side{};  ///< from which the scan is looked into, relative to the beam
    bool front = false;                   ///< whether a front, or none, was chosen
};

/// Each with its own confidence.
struct OpeningFinds {
    BeamGuess beam;                       ///< sure and without evidence if a person said it
    ViewDirection lean{};                 ///< of the beam against its axis, where the file says so
    std::optional<ViewDirection> side{};  ///< that a person said; none: the scan is looked into from the probe
    /// Looked for along the side. Nobody cuts along a beam that is not sure, unless a person said the side.
    std::optional<NearCutFinding> cut{};
};

/// Looks at a volume that was read from a file, the first phase of a study; `search` looks for the cut. The result is
/// empty only where it was cancelled.
[[nodiscard]] std::optional<OpeningFinds> findOnOpening(const Volume& volume, const Progress& progress = {},
                                                        const SaidOnOpening& said = {},
                                                        NearCutSearch search = &findNearCut);

/// Whether a program may make a front of what was found without asking.
[[nodiscard]] bool makesFront(const OpeningFinds& finds);

/// The document with the finds that are sure: the beam, the side, and the flat cut as its front (rounded to 0.1 mm, as
/// people set it). Tube cores look from the side; the pose stays as it is. What is not sure stays as it is.
[[nodiscard]] Document withFinds(Document document, const OpeningFinds& finds);

/// A study that was just opened, as far as its document depends on it.
struct OpenedStudy {
    StudyReference reference{};
    DataBox box{};                        ///< of the phase that is shown first
    int phases = 1;                       ///< at least 1
    int phasesBefore = 1;                 ///< of the study that was open before; 1 if there was none
    std::optional<OpeningFinds> finds{};  ///< none of a simulated scan, whose beam is known
};

/// The documents that a study begins with.
struct OpenedDocuments {
    Document plain;  ///< as if nothing had been found
    Document found;  ///< with the finds: what is shown
};

/// The documents of a study that was opened after `before` was shown: openedDocument(), with all data in a picture of
/// width / height `aspect` (> 0), seen from the scene's side. The object of a 4D study moves, unless another motion was
/// chosen in a 4D study before it.
[[nodiscard]] OpenedDocuments openedDocuments(const Document& before, const OpenedStudy& study, double aspect);

}  // namespace echolucent
