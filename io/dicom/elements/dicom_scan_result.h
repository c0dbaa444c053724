// What the first walk over a DICOM file finds.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "io/dicom/elements/dicom_attributes.h"

namespace echolucent {

/// Bytes of the file that are to be read otherwise than they are written.
struct DicomRepair {
    std::uint64_t offset = 0;  ///< in the file, of the first byte
    std::string bytes;         ///< in place of as many; behind the end of the file they are added to it
};

/// How far a walk could follow a file.
enum class DicomScanEnd {
    whole,    ///< to its end, or as far as was asked for
    inMeta,   ///< it ends within its meta header or right behind it
    cut,      ///< it ends in the middle of an element or of a sequence
    damaged,  ///< what stands there is no element
    deflate,  ///< its deflated data are cut or damaged
};

/// An element that declares more than the file holds.
struct LackingElement {
    DicomTag tag;
    std::uint64_t bytesDeclared = 0;
    std::uint64_t bytesHeld = 0;
};

/// What the walk has seen.
struct DicomScan {
    std::string transferSyntax;  ///< UID from the meta header; empty where it has none
    std::string sopClass;        ///< SOP class from the meta header, else from the data set; empty where it has none
    bool hasPixelData = false;   ///< whether (7FE0,0010) stands at top level
    std::uint64_t pixelBytesDeclared = 0;  ///< the length of (7FE0,0010) as written; 0 where it is encapsulated
    std::uint64_t pixelBytesHeld = 0;      ///< how many of the declared bytes the file holds
    std::uint64_t pixelStart = 0;  ///< where the value of (7FE0,0010) begins in the file; 0 where it is deflated
    bool pixelsEnd = false;        ///< whether the walk came to the end of (7FE0,0010)
    /// The element in which the walk ended, where it lacks more than a MiB. The library takes memory for what an
    /// element declares before it looks at what is there, so that it is given no such file.
    std::optional<LackingElement> lacking;
    bool holdsKretz = false;           ///< whether a volume of GE's (kretzVolumeIn()) stands behind the pixels
    std::uint64_t kretzBytesHeld = 0;  ///< how many bytes of it the file holds
    DicomScanEnd end = DicomScanEnd::whole;
    std::uint64_t endPosition = 0;    ///< where the walk ended, in what the file unpacks to where it is deflated
    std::uint64_t fileBytes = 0;      ///< the file's size
    std::uint64_t unpackedBytes = 0;  ///< of the data set where it is deflated; else 0
    /// What a reader that is as strict as the standard needs to get through: delimiters missing at the end of the file,
    /// lengths of sequences that are declared empty and are not, items that belong to no sequence.
    std::vector<DicomRepair> repairs;
    std::vector<std::string> notes;  ///< sentences on the repairs, each once
};

/// Sequences may lie this deep in each other; the standard's own objects need fewer than ten. DCMTK recurses into every
/// level and runs out of stack in the thousands.
constexpr int deepestSequence = 64;
/// A file holds no more elements and items than this; a study of 20 volumes of 500 frames each needs 200,000. DCMTK
/// takes two microseconds and 200 bytes for each.
constexpr std::size_t mostElements = 500000;
/// A data set or item holds no more elements than this, whose number DCMTK's searches take time in proportion to.
constexpr std::size_t mostElementsOfOne = 20000;
/// More repairs than this are not made: files that need any need a few.
constexpr std::size_t mostRepairs = 1000;

/// What is wrong with files that hold too much, as in Failure::problem.
[[nodiscard]] std::string nestedTooDeep();
[[nodiscard]] std::string tooManyElements();

}  // namespace echolucent
