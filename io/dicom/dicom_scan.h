// A first walk over a DICOM file, before the DICOM library sees it: flat, without recursion, bounded by the file.
#pragma once

#include <cstdint>
#include <string>

#include "processing/progress.h"
#include "processing/result.h"

namespace echolucent {

/// What the walk has seen.
struct DicomScan {
    std::string transferSyntax;  ///< UID from the meta header; empty: none
    std::string sopClass;        ///< media storage SOP class from the meta header; may be empty
    std::uint64_t fileSize = 0;
    bool hasPixelData = false;             ///< (7FE0,0010) at top level
    std::uint64_t pixelBytesDeclared = 0;  ///< its length as written; 0 where it is encapsulated
    std::uint64_t pixelBytesHeld = 0;      ///< how many of them the file holds
};

/// Sequences may lie this deep in each other; the standard's own objects need fewer than ten. DCMTK recurses into every
/// level and runs out of stack in the thousands.
constexpr int deepestSequence = 64;

/// Walks the file's elements. Fails only where sequences are nested too deep, where the file cannot be opened, or where
/// the person cancelled, for which `progress` is polled at every element. Whatever else is wrong with the file is left
/// for the DICOM library to name.
[[nodiscard]] Result<DicomScan> scanDicom(const std::string& path, const Progress& progress);

}  // namespace echolucent
