// Reads volumes from DICOM: a folder of slices or one multi-frame file. docs/formats-read.md lists what it understands.
#pragma once

#include <string>

#include "io/files/input_file.h"
#include "io/study/study.h"

namespace echolucent {

/// Reads an opened DICOM file. Of a DICOMDIR it reads the series that the options name, else the first of its list.
/// DCMTK's types stay behind this header. `progress` is polled for cancel between files, elements and frames.
[[nodiscard]] Result<Study> readDicom(const InputFile& file, const ReadOptions& options, const Progress& progress);
/// Reads a series of the folder or DICOMDIR at `path`: the one that the options name, else the first of listSeries().
[[nodiscard]] Result<Study> readDicomFolder(const std::string& path, const ReadOptions& options,
                                            const Progress& progress);

}  // namespace echolucent
