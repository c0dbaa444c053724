// What is found in a volume when it is opened: from where sound came, from which side it shows most, and where to cut.
// Also the document that begins with these finds.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>

#include "processing/beam/beam_guess.h"
#include "processing/document/document.h"
#include "processing/near_cut/near_cut.h"
#include "processing/progress.h"
#include "processing/sides/side_search.h"
#include "processing/volume/volume.h"

namespace echolucent {

/// What a person has said about a study that is opened. What is said is taken and not searched for.
struct SaidOnOpening {
    std::optional<BeamAxis> beam{};
    std::optional<ViewDirection> direction{};  ///< in which the scan is looked into, relative to the beam
    std::string side{};  ///< the side from which the scan is looked into, as in sideNamed(); not beside a direction
    bool front = false;  ///< whether a person chose a front, or chose none
    std::string sideOfKind{};  ///< word of the side that a person took last of such a scan; "" if there is none
};

/// Who chose the side from which a scan is opened.
enum class SideSource {
    found,       ///< it shows most (findSides()), or it is the probe's and no side was looked for
    person,      ///< a person said it of this study
    remembered,  ///< a person took it last of such a scan
};
/// "found", "person", "remembered".
[[nodiscard]] std::string_view nameOf(SideSource source);

/// What was found or said; beam and cut have a confidence each.
struct OpeningFinds {
    BeamGuess beam;        ///< sure and without evidence if a person said it
    ViewDirection lean{};  ///< of the beam against its axis, if the file says so and no person said the beam
    /// The six sides. Null if they were not looked for: a person said a direction, or the beam or the front, but no
    /// side. Then the scan is looked into in that direction, or from the probe.
    std::shared_ptr<const SidesFinding> sides{};
    /// Place among `sides` of the one from which the scan is opened. No value without `sides`, or if the scan has no
    /// side of the name that was said.
    std::optional<std::size_t> place{};
    ViewDirection side{};  ///< from which the scan is opened, relative to the beam that withFinds() takes
    SideSource source = SideSource::found;
    /// Searched for along the side. Empty if a person chose the front.
    std::optional<NearCutFinding> cut{};
    /// Scene::exposure for what is seen along the side, behind the cut if makesFront(). 1 if `cut` was not searched
    /// for.
    double exposure = 1.0;
};

/// Searches a volume that was read from a file, the first phase of a study. Of a large volume the coarse one
/// (coarseVolumeOf()) says which side shows most, so that its picture before all is read shows the same side. The
/// result is empty only if the search was cancelled.
[[nodiscard]] std::optional<OpeningFinds> findOnOpening(const Volume& volume, const Progress& progress = {},
                                                        const SaidOnOpening& said = {});

/// The document with the finds that are sure: the beam, the side, the cut as its front if makesFront() (bowed if a
/// bowed one was found, else rounded to 0.1 mm as people set it), and the exposure. Tube cores look from the side. The
/// pose and everything that is not sure stay.
[[nodiscard]] Document withFinds(Document document, const OpeningFinds& finds);

/// A study that was just opened: all that its document depends on.
struct OpenedStudy {
    StudyReference reference{};
    DataBox box{};                        ///< of the phase that is shown first
    int phases = 1;                       ///< at least 1
    int phasesBefore = 1;                 ///< of the study that was open before; 1 if there was none
    std::optional<OpeningFinds> finds{};  ///< none for a simulated scan, whose beam is known
};

/// The documents that a study begins with.
struct OpenedDocuments {
    Document plain;  ///< as if nothing had been found
    Document found;  ///< with the finds: the one that is shown
};

/// The documents of a study that is opened after `before` was shown: openedDocument() with all data in a picture of
/// width / height `aspect` (> 0), seen from the scene's side. In a 3D study the probe moves, in a 4D study the object.
/// If both this study and the one before are 4D, the chosen motion stays.
[[nodiscard]] OpenedDocuments openedDocuments(const Document& before, const OpenedStudy& study, double aspect);

}  // namespace echolucent
