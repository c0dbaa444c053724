// What a DICOM data set states of its pixels as a whole: lossy compression, burnt-in text.
#pragma once

#include <string>

#include "io/study/study_assembly.h"

class DcmDataset;

namespace echolucent {

struct StatedLoss {
    LossyCompression compression = LossyCompression::unknown;
    std::string source;  ///< tags that gave it
};

/// What a file tells of lossy compression. Images of ultrasound must state it where there was loss (DICOM PS3.3, US
/// Image Module: type 1C); for others the attribute is optional.
[[nodiscard]] StatedLoss statedLoss(DcmDataset& dataset);

/// Adds what a data set tells of lossy compression to `parts`: loss in one of several files is loss of the study, and
/// "no" needs all of them.
void sayLoss(DcmDataset& dataset, StudyParts& parts);

/// Adds what a data set tells of burnt-in text to `parts`: text in one of several files is text in the study. A file
/// that does not say is unknown where it holds pictures, cines and colour among them, which are often copies of a
/// screen; where `alwaysVolume` says that the voxels never were on a screen, it is taken as free of text.
void sayBurnedInText(DcmDataset& dataset, bool alwaysVolume, StudyParts& parts);

}  // namespace echolucent
