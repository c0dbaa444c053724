// How the frames of a DICOM multi-frame object make up volumes.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "io/dicom/frames/functional_groups.h"
#include "io/dicom/frames/ultrasound_frame.h"
#include "io/study/study.h"
#include "processing/result.h"
#include "processing/volume/volume.h"

class DcmItem;

namespace echolucent {

/// The frames of every phase in slice order, and the geometry they share.
struct FrameLayout {
    std::vector<std::vector<std::size_t>>
        phases;               ///< frames counted from 0; of one frame each where there is no volume
    VolumeGeometry geometry;  ///< only its size is set where the phases hold one frame each
    std::string spacingSource;
    bool inPlaneSpacingKnown = false;  ///< of pictures taken as slices, whose distance is a guess
    std::optional<double> phaseSeconds;
    std::string phaseSource;  ///< what told the phases apart
    std::optional<FoundProbe> probe;
    std::vector<ImportFact> facts;
    std::vector<std::string> warnings;
};

/// How many frames an object holds, and of how many pixels.
struct FrameExtent {
    std::size_t frames = 0;  ///< at least 2
    std::int64_t columns = 0, rows = 0;
};

/// Lays frames out as a volume, or as the phases of one: as their functional groups say, else by the old attributes at
/// top level (classicPlacements()). Of functional groups, the planes in the patient give the geometry where all frames
/// have them, else those in the volume's frame of reference. Fails (unreadable, about the file at `path`) where some
/// frames have no place, and where places, dimensions and times contradict each other; with
/// Failure::framesCouldBeSlices where the frames are no volume. `progress` is polled for cancel.
[[nodiscard]] Result<FrameLayout> layOutFrames(DcmItem& dataset, const std::string& path, const FrameExtent& extent,
                                               const Progress& progress);

}  // namespace echolucent
