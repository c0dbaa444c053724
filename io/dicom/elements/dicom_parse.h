// Lets DCMTK parse a file and keeps it within bounds: cancel, repairs, inflating, depth of nesting and work.
#pragma once

#include <cstdint>

#include "io/dicom/elements/dicom_scan_result.h"
#include "io/files/input_file.h"
#include "processing/progress.h"

class DcmDataset;

namespace echolucent {

enum class DicomParseEnd {
    whole,    ///< everything asked for was parsed
    cut,      ///< the file ends in the middle of an element
    damaged,  ///< the bytes before the position are no DICOM element
    tooDeep,  ///< the file nests deeper than any true object; the scan missed this
    tooMuch,  ///< the file holds more elements than any true object; the scan missed this
};

struct DicomParsed {
    DicomParseEnd end = DicomParseEnd::whole;
    std::uint64_t position = 0;  ///< in the file; if it is deflated, unpacked bytes count
};

/// Parses the data set of an opened file into `dataset`. `scan` says where the data set begins and ends, how it is
/// written and what must be repaired. Without `withPixels` parsing stops at Pixel Data, and elements that damage cut
/// are left out. DCMTK recurses into every level of nesting. Parsing stops after a few megabytes of stack, or after as
/// many reads as the largest true objects need. `progress` is polled for cancel at every read; after a cancel
/// DicomParsed::end has no meaning.
[[nodiscard]] DicomParsed parseDicom(DcmDataset& dataset, const InputFile& input, const DicomScan& scan,
                                     bool withPixels, const Progress& progress);

}  // namespace echolucent
