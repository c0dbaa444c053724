// The two shapes of a DICOM volume: a folder of slices and one multi-frame file.
#pragma once

#include "io/dicom/dicom_file.h"
#include "io/study.h"
#include "io/study_assembly.h"

class DcmItem;

namespace echolucent {

/// One file with several frames.
[[nodiscard]] Result<Study> readMultiframe(const DicomFile& file, const ReadOptions& options, const Progress& progress);

/// The series with most slices in a folder and the folders in it.
[[nodiscard]] Result<Study> readSeriesFolder(const std::string& path, const ReadOptions& options,
                                             const Progress& progress);

/// Maker and model of the scanner, modality: never anything about the patient.
[[nodiscard]] std::vector<ImportFact> equipmentFacts(DcmItem& dataset);

/// "Add --frames-as-slices ...": the refusal of pictures that may be taken as slices all the same.
[[nodiscard]] tl::unexpected<Failure> framesWithoutGeometry(const std::string& path, const std::string& problem);

}  // namespace echolucent
