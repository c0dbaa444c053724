// What the readers of DICOM volumes in one file offer, and the words that they share with the reader of series
// (io/study/series_list.h).
#pragma once

#include "io/dicom/elements/dicom_file.h"
#include "io/study/study.h"
#include "io/study/study_assembly.h"

class DcmItem;

namespace echolucent {

/// Reads the volume of one file: frames, or a maker's private volume. Call it in a thread with a large stack.
[[nodiscard]] Result<Study> readDicomFile(const InputFile& input, const ReadOptions& options, const Progress& progress);

/// Reads the GE volume in a file, else its frames as a volume or as the phases of one. Fails if there is a single
/// frame.
[[nodiscard]] Result<Study> readMultiframe(const DicomFile& file, const ReadOptions& options, const Progress& progress);

/// Reads an object that is kept in several files (a concatenation) as the volume of one file. `paths` holds its parts
/// in their order. Fails too if the parts do not belong together (joinedHeader()). Call it in a thread with a large
/// stack.
[[nodiscard]] Result<Study> readConcatenation(const std::vector<std::string>& paths, const ReadOptions& options,
                                              const Progress& progress);

/// The name that refusals give to the attribute of a slice's place.
constexpr const char* imagePositionName = "(0020,0032) Image Position";

/// Modality, maker and model of the scanner for the import report; never anything about the patient.
[[nodiscard]] std::vector<ImportFact> equipmentFacts(DcmItem& dataset);

/// The note on slices of known distance whose pixels have no known size. The size is taken to be that distance.
[[nodiscard]] std::string pixelSizeUnknown(double betweenSlices);

/// The refusal of a picture that is alone.
[[nodiscard]] tl::unexpected<Failure> singlePicture(const std::string& path);

/// The refusal of pictures that are no volume, because of `problem`, with the remedy --frames-as-slices.
[[nodiscard]] tl::unexpected<Failure> framesWithoutGeometry(const std::string& path, const std::string& problem);

}  // namespace echolucent
