// Which of the six sides of a scan shows most. The search needs no picture.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>

#include "processing/near_cut/near_cut.h"
#include "processing/progress.h"
#include "processing/sides/scan_planes.h"
#include "processing/sides/side.h"
#include "processing/sides/side_score.h"
#include "processing/viewpoint/viewpoint.h"
#include "processing/volume/volume.h"

namespace echolucent {

/// A side with what was found for it.
struct JudgedSide {
    Side side{};
    NearCutFinding front{};  ///< searched for along the side; the side has one without asking if makesFront()
    SideScore score{};
    double exposure = 1.0;  ///< exposureFor() of the face that the side shows behind its front
};

/// Why a side comes first.
enum class FirstSideReason {
    nothingShows,             ///< no side scores anything
    tooLittleOpenElsewhere,   ///< others score clearly more, but open too little of their pictures
    noneClearlyMore,          ///< it is the first one, and no other that opens enough scores clearly more
    showsMost,                ///< no side that opens enough scores more
    firstInTheCoarsePicture,  ///< none of these: the coarse volume is shown from there before all is read
};

/// The six sides of a scan, and which one comes first (docs/sides.md).
struct SidesFinding {
    ScanPlanes planes{};
    std::array<JudgedSide, std::tuple_size_v<Sides>> sides{};  ///< in the order of sidesOf()
    /// The least SideScore::opened with which a side comes before the first one, [0,1].
    double leastOpened = 0.0;
    std::size_t best = probeSide;  ///< place among `sides` of the one that the scan is opened from
    FirstSideReason reason = FirstSideReason::nothingShows;  ///< why `best` comes first
    std::string sentence{};                                  ///< for a person: which side comes first, and why
};

/// The finding if another side comes first; reason and sentence say why.
[[nodiscard]] SidesFinding withFirst(SidesFinding finding, std::size_t place);

/// Finds the front of each side, scores the sides and picks the best. `fromProbe` is the view from the probe, and
/// `beamSure` says whether it is sure; else sides are numbered. `shapes` says which fronts are searched for; a side
/// with a bowed front is scored with it, else with the flat one. If no side is at least a ninth better than the first
/// one, which is the one from the probe, that one comes first. A side that shows little behind fluid (SideScore::opened
/// below a tenth, or a fifth if the beam is not sure) comes first only if it is the first one. The voxels are read once
/// for all sides. The result has the same bits for any number of threads, and is empty only if progress.cancel was
/// raised.
[[nodiscard]] std::optional<SidesFinding> findSides(const Volume& volume, const Viewpoint& fromProbe, bool beamSure,
                                                    CutShapes shapes = CutShapes::flat, const Progress& progress = {});

}  // namespace echolucent
