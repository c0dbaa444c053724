// What a DICOM data set states of all its pixels: lossy compression, burnt-in text.
#pragma once

#include <string>

#include "io/study/study_assembly.h"

class DcmDataset;

namespace echolucent {

struct StatedLoss {
    LossyCompression compression = LossyCompression::unknown;
    std::string source;  ///< the tags that state it
};

/// What a data set tells of lossy compression. Ultrasound images must state a loss (DICOM PS3.3, US Image Module: type
/// 1C), so one that states nothing lost nothing, unless it is JPEG 2000. For other images the attribute is optional, so
/// one that states nothing is unknown.
[[nodiscard]] StatedLoss statedLoss(DcmDataset& dataset);

/// Adds what a data set tells of lossy compression to `parts`. The study has a loss if one of its files has. It has
/// none only if every file says so.
void sayLoss(DcmDataset& dataset, StudyParts& parts);

/// Adds what a data set tells of burnt-in text to `parts`. The study has text if one of its files has. A file that does
/// not say is unknown if it may hold pictures of a screen: a cine, or pictures in colour. It counts as free of text if
/// it is a grey slice or an Enhanced US Volume, or if `alwaysVolume` says that its voxels never were on a screen.
void sayBurnedInText(DcmDataset& dataset, bool alwaysVolume, StudyParts& parts);

}  // namespace echolucent
