// How the frames of a DICOM multi-frame object make up volumes.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "io/dicom/frames/frame_vectors.h"
#include "io/dicom/frames/functional_groups.h"
#include "io/dicom/frames/picture_scale.h"
#include "io/dicom/frames/ultrasound_frame.h"
#include "io/study/study.h"
#include "processing/result.h"
#include "processing/volume/volume.h"

class DcmItem;

namespace echolucent {

/// The frames of every phase in slice order, and the geometry they share.
struct FrameLayout {
    std::vector<std::vector<std::size_t>> phases;  ///< frames counted from 0
    VolumeGeometry geometry;                       ///< of every phase
    std::string spacingSource;
    bool inPlaneSpacingKnown = false;  ///< whether pixels have a known size although the distance of slices is a guess
    PhaseTimes phaseTimes{};
    std::string phaseSource;  ///< the attribute that told the phases apart
    std::optional<FoundProbe> probe;
    std::vector<ImportFact> facts;
    std::vector<std::string> warnings;
};

struct FrameExtent {
    std::size_t frames = 0;  ///< at least 2
    std::int64_t columns = 0, rows = 0;
};

/// Puts the times of phases by vectors, the vectors' names and the notes on them into `layout`.
void takeVectors(const FrameVectors& vectors, FrameLayout& layout);

/// Takes the spacing of slices, its source and the notes on it into `layout`.
void takeScale(const SliceScale& scale, FrameLayout& layout);

/// Lays frames out as a volume, or as the phases of one: by their functional groups, else by the old attributes at top
/// level (classicPlaces()) and the vectors of nuclear medicine (readFrameVectors()). If all frames of tissue have
/// planes in the patient, these give the geometry; else the planes in the volume's frame of reference do. Fails
/// (unreadable, about the file at `path`) if some frames have no place, or if places, dimensions and times contradict
/// each other. If the frames are a cine, or if the old attributes make no sense, it fails with
/// Failure::framesCouldBeSlices. A single plane of tissue fails without it. `progress` is polled for cancel.
[[nodiscard]] Result<FrameLayout> layOutFrames(DcmItem& dataset, const std::string& path, const FrameExtent& extent,
                                               const Progress& progress);

}  // namespace echolucent
