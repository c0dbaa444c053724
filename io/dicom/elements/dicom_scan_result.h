// The findings of the first walk over a DICOM file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "io/dicom/elements/dicom_attributes.h"

namespace echolucent {

/// Bytes that replace bytes of the file when it is read.
struct DicomRepair {
    std::uint64_t offset = 0;  ///< in the file, of the first byte
    std::string bytes;         ///< these replace as many bytes of the file; behind its end they are added
};

/// How far a walk could follow a file.
enum class DicomScanEnd {
    whole,    ///< to the file's end, or as far as asked for
    inMeta,   ///< the file ends within its meta header or right behind it
    cut,      ///< the file ends in the middle of an element or a sequence
    damaged,  ///< the bytes there are no element, or (in a DICOMDIR) one that runs out of its item to the end
    deflate,  ///< the deflated data are cut or damaged
};

/// An element that declares more than the file holds.
struct LackingElement {
    DicomTag tag;
    std::uint64_t bytesDeclared = 0;
    std::uint64_t bytesHeld = 0;
};

struct DicomScan {
    /// UID of how the pixels are coded: that of the meta header, or if the data set contradicts it, the one that fits
    /// the data set. Empty if the meta header has none and the pixels are not split into fragments.
    std::string transferSyntax;
    /// UID of how the elements are written. It differs from transferSyntax if pixels are in fragments although the
    /// elements are written in implicit VR or big endian. Empty if the writing must be guessed from the first element.
    std::string elementSyntax;
    std::uint64_t datasetStart = 0;        ///< the first element behind the meta header begins here
    std::string sopClass;                  ///< UID from the meta header, else from the data set; else empty
    bool hasPixelData = false;             ///< whether (7FE0,0010) stands at top level
    std::uint64_t pixelBytesDeclared = 0;  ///< the length of (7FE0,0010) as written; 0 if encapsulated
    bool pixelsInFragments = false;        ///< whether (7FE0,0010) is encapsulated
    std::uint64_t pixelBytesHeld = 0;      ///< how many of the declared bytes the file holds
    std::uint64_t pixelStart = 0;          ///< the value of (7FE0,0010) begins here in the file; 0 if it is deflated
    bool pixelsEnd = false;                ///< whether the walk reached the end of (7FE0,0010)
    /// The element in which the walk ended, if the file lacks more than a MiB of it. The pixels, and an element of
    /// undefined length, do not count. DCMTK allocates what an element declares before it looks for the bytes, so DCMTK
    /// gets no such file.
    std::optional<LackingElement> lacking;
    bool holdsKretz = false;           ///< whether a GE volume (kretzVolumeIn()) stands behind the pixels
    std::uint64_t kretzBytesHeld = 0;  ///< how many bytes of the GE volume the file holds
    DicomScanEnd end = DicomScanEnd::whole;
    /// Where the walk ended, in the file. If it is deflated, unpacked bytes count; with DicomScanEnd::deflate only
    /// these do.
    std::uint64_t endPosition = 0;
    std::uint64_t fileBytes = 0;  ///< the file's size
    /// What stands from this byte on must not be read: it lies behind whole pixels and is no element, or not a whole
    /// one. No value if the file is used to its end.
    std::optional<std::uint64_t> usedBytes;
    std::uint64_t unpackedBytes = 0;  ///< of the data set if it is deflated; else 0
    /// The repairs that a reader as strict as the standard needs. They concern delimiters missing at the end of the
    /// file, sequences that are falsely declared empty, and items outside any sequence.
    std::vector<DicomRepair> repairs;
    std::vector<std::string> notes;  ///< sentences on the repairs, each once
};

/// Sequences may be nested this deep; the standard's own objects need fewer than ten levels. DCMTK recurses into every
/// level and runs out of stack after some thousand.
constexpr int deepestSequence = 64;
/// A file may hold at most this many elements, items and fragments together. A study of 20 volumes of 500 frames each
/// needs 200,000. DCMTK takes two microseconds and 200 bytes for each.
constexpr std::size_t mostElements = 500000;
/// One data set or item may hold at most this many elements. DCMTK's searches take time in proportion to their number.
constexpr std::size_t mostElementsOfOne = 20000;
/// A file may need at most this many repairs. Damaged files need a few.
constexpr std::size_t mostRepairs = 1000;

/// Problems of files that hold too much, as in Failure::problem.
[[nodiscard]] std::string nestedTooDeep();
[[nodiscard]] std::string tooManyElements();

}  // namespace echolucent
