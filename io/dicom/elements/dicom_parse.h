// What lets DCMTK parse a file and keeps it within bounds: cancel, repairs, inflating, depth of nesting and work.
#pragma once

#include <cstdint>

#include "io/dicom/elements/dicom_scan_result.h"
#include "io/files/input_file.h"
#include "processing/progress.h"

class DcmFileFormat;

namespace echolucent {

/// How parsing ended.
enum class DicomParseEnd {
    whole,    ///< all that was asked for was parsed
    cut,      ///< the file ends in the middle of an element
    damaged,  ///< what stands before the position is no DICOM element
    tooDeep,  ///< it nests deeper than any true object, which the scan did not see
    tooMuch,  ///< it holds more elements than any true object, which the scan did not see
};

/// How parsing ended, and where.
struct DicomParsed {
    DicomParseEnd end = DicomParseEnd::whole;
    std::uint64_t position = 0;  ///< in the file; in what the file unpacks to where it is deflated
};

/// Parses an opened file into `file`, with the repairs of `scan`; where `withPixels` is not set, up to Pixel Data,
/// and without the element that damage cut.
/// DCMTK recurses into every level of nesting: it is stopped after a few megabytes of stack, whatever it takes for a
/// sequence, and after as many reads as the largest true objects need. `progress` is polled for cancel at every read,
/// after which the end has no meaning.
[[nodiscard]] DicomParsed parseDicom(DcmFileFormat& file, const InputFile& input, const DicomScan& scan,
                                     bool withPixels, const Progress& progress);

}  // namespace echolucent
