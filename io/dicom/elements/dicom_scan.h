// The first walk over a DICOM file, before DCMTK sees it. It does not recurse, and the file's size bounds it.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "io/dicom/elements/dicom_scan_result.h"
#include "io/files/input_file.h"
#include "processing/progress.h"
#include "processing/result.h"

namespace echolucent {

/// The endings of DICOM files' names, in lower case; many names have none.
constexpr std::array<std::string_view, 3> dicomEndings{".dcm", ".dicom", ".ima"};

/// Whether the beginning of a file looks like DICOM, with or without preamble and meta header. Takes at least the first
/// 132 bytes, or the whole file.
[[nodiscard]] bool looksLikeDicom(std::string_view beginning);

/// Walks the elements of an opened file. If `headerOnly` is set, the walk ends behind the private group in which GE
/// keeps volumes; this group follows the pixel data. In a QLAB file the walk ends behind the pixel data.
/// Fails if
/// - sequences are nested too deep or stand in the meta header,
/// - there are too many elements, or too many out of order,
/// - an element of the picture or its place stands twice with different values, or too many stand twice with one value,
/// - a directory record's type is longer than DCMTK can read,
/// - more than mostRepairs are needed,
/// - deflated bytes unpack to more than mostUnpackedBytes(),
/// - the person cancelled. `progress` is polled at every element and within long deflated values.
/// If the walk cannot follow the file for another reason, DicomScan::end names it.
[[nodiscard]] Result<DicomScan> scanDicom(const InputFile& file, const Progress& progress, bool headerOnly = false);

}  // namespace echolucent
