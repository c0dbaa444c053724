// The two shapes of a DICOM volume: a folder of slices and one multi-frame file.
#pragma once

#include "io/dicom/dicom_file.h"
#include "io/study.h"
#include "io/study_assembly.h"

class DcmItem;

namespace echolucent {

/// Reads one file with several frames as a volume, or as the phases of one.
[[nodiscard]] Result<Study> readMultiframe(const DicomFile& file, const ReadOptions& options, const Progress& progress);

/// Reads the series with most slices in the folder at `path` and the folders in it.
[[nodiscard]] Result<Study> readSeriesFolder(const std::string& path, const ReadOptions& options,
                                             const Progress& progress);

/// Modality, maker and model of the scanner for the import report; never anything about the patient.
[[nodiscard]] std::vector<ImportFact> equipmentFacts(DcmItem& dataset);

/// The refusal of pictures that are no volume (`problem` says why), with the remedy --frames-as-slices.
[[nodiscard]] tl::unexpected<Failure> framesWithoutGeometry(const std::string& path, const std::string& problem);

}  // namespace echolucent
