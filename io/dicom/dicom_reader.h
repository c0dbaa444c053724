// Reads volumes from DICOM: a folder of slices or one multi-frame file. docs/formats-read.md says what is understood.
#pragma once

#include <string>
#include <string_view>

#include "io/input_file.h"
#include "io/study.h"

namespace echolucent {

/// Whether the beginning of a file looks like DICOM, with or without preamble and meta header.
[[nodiscard]] bool looksLikeDicom(std::string_view beginning);

/// Reads an opened DICOM file. No type of the DICOM library
/// crosses this line. `progress` is polled for cancel between files, elements and frames.
[[nodiscard]] Result<Study> readDicom(const InputFile& file, const ReadOptions& options, const Progress& progress);
/// Reads the series that the options name, else the one with most slices, of the folder at `path`.
[[nodiscard]] Result<Study> readDicomFolder(const std::string& path, const ReadOptions& options,
                                            const Progress& progress);

}  // namespace echolucent
