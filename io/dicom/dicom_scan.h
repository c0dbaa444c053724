// A first walk over a DICOM file, before the DICOM library sees it: flat, without recursion, bounded by the file.
#pragma once

#include <cstdint>
#include <string>

#include "io/input_file.h"
#include "processing/progress.h"
#include "processing/result.h"

namespace echolucent {

/// What the walk has seen.
struct DicomScan {
    std::string transferSyntax;  ///< UID from the meta header; empty where it has none
    std::string sopClass;        ///< media storage SOP class from the meta header; empty where it has none
    std::uint64_t fileSize = 0;
    bool hasPixelData = false;             ///< whether (7FE0,0010) stands at top level
    std::uint64_t pixelBytesDeclared = 0;  ///< the length of (7FE0,0010) as written; 0 where it is encapsulated
    std::uint64_t pixelBytesHeld = 0;      ///< how many of the declared bytes the file holds
};

/// Sequences may lie this deep in each other; the standard's own objects need fewer than ten. DCMTK recurses into every
/// level and runs out of stack in the thousands.
constexpr int deepestSequence = 64;

/// Walks the elements of an opened file. Fails only where sequences are nested too deep, or where the person cancelled,
/// for which `progress` is polled at every element. Whatever else is wrong with the file is left for the DICOM library
/// to name.
[[nodiscard]] Result<DicomScan> scanDicom(const InputFile& file, const Progress& progress);

}  // namespace echolucent
