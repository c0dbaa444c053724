// The shapes of a DICOM volume: a folder of slices (io/study/series_list.h) and one multi-frame file.
#pragma once

#include "io/dicom/elements/dicom_file.h"
#include "io/study/study.h"
#include "io/study/study_assembly.h"

class DcmItem;

namespace echolucent {

/// Reads whatever volume one file holds: frames, or a maker's private volume. To be called in a thread with a large
/// stack.
[[nodiscard]] Result<Study> readDicomFile(const InputFile& input, const ReadOptions& options, const Progress& progress);

/// Reads one file with several frames as a volume, or as the phases of one.
[[nodiscard]] Result<Study> readMultiframe(const DicomFile& file, const ReadOptions& options, const Progress& progress);

/// What a refusal calls the attribute that says where a slice lies.
constexpr const char* imagePositionName = "(0020,0032) Image Position";

/// Modality, maker and model of the scanner for the import report; never anything about the patient.
[[nodiscard]] std::vector<ImportFact> equipmentFacts(DcmItem& dataset);

/// The note on slices whose distance is known and whose pixels are of unknown size, which is assumed to be the same.
[[nodiscard]] std::string pixelSizeUnknown(double betweenSlices);

/// The refusal of pictures that are no volume (`problem` says why), with the remedy --frames-as-slices.
[[nodiscard]] tl::unexpected<Failure> framesWithoutGeometry(const std::string& path, const std::string& problem);

}  // namespace echolucent
