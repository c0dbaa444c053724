// A first walk over a DICOM file, before the DICOM library sees it: flat, without recursion, bounded by the file.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "io/dicom/elements/dicom_scan_result.h"
#include "io/files/input_file.h"
#include "processing/progress.h"
#include "processing/result.h"

namespace echolucent {

/// How names of DICOM files end, in lower case; many have no ending.
constexpr std::array<std::string_view, 3> dicomEndings{".dcm", ".dicom", ".ima"};

/// Whether the beginning of a file (132 bytes or more, or all of it) looks like DICOM, with or without preamble and
/// meta header.
[[nodiscard]] bool looksLikeDicom(std::string_view beginning);

/// Walks the elements of an opened file; where `headerOnly` is set, up to the private group behind its pixel data.
/// Fails where sequences are nested too deep or stand in the meta header, where there are too many elements or too many
/// out of order, where an element that describes the picture or its place stands twice with different values, where
/// more than mostRepairs are needed, where deflated bytes unpack to more than mostUnpackedBytes() (DCMTK never sees
/// these), or where the person cancelled, for which `progress` is polled at every element and within long values that
/// are deflated. Where the walk cannot follow the file otherwise, DicomScan::end says so.
[[nodiscard]] Result<DicomScan> scanDicom(const InputFile& file, const Progress& progress, bool headerOnly = false);

}  // namespace echolucent
