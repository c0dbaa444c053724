// Reads volumes from DICOM: a folder of slices or one multi-frame file. docs/formats-read.md says what is understood.
#pragma once

#include <string>

#include "io/files/input_file.h"
#include "io/study/study.h"

namespace echolucent {

/// Reads an opened DICOM file; of a DICOMDIR the series that the options name, else the first of its list. No type of
/// the DICOM library crosses this line. `progress` is polled for cancel between files, elements and frames.
[[nodiscard]] Result<Study> readDicom(const InputFile& file, const ReadOptions& options, const Progress& progress);
/// Reads the series that the options name, else the first of listSeries(), of the folder or DICOMDIR at `path`.
[[nodiscard]] Result<Study> readDicomFolder(const std::string& path, const ReadOptions& options,
                                            const Progress& progress);

}  // namespace echolucent
