// How the elements of a DICOM data set are written: value representations, byte order, deflated or not.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "io/files/input_file.h"

namespace echolucent {

struct DicomWriting {
    bool implicitVr = false, bigEndian = false, deflated = false;
    friend bool operator==(const DicomWriting&, const DicomWriting&) = default;
};

/// A tag whose bytes were read in the wrong order.
[[nodiscard]] std::uint32_t swappedTag(std::uint32_t tag);
/// The writing that a transfer syntax states; no value if its UID is empty or unknown.
[[nodiscard]] std::optional<DicomWriting> statedWriting(const std::string& transferSyntax);
/// The writing as DCMTK guesses it if no transfer syntax states it. It goes by the first tag (read as little endian)
/// and the next two bytes.
[[nodiscard]] DicomWriting guessedWriting(std::uint32_t tag, std::string_view letters);

/// The transfer syntax (UID) of uncompressed pixels by which a data set must be read that begins at byte `start` and
/// cannot be written as `stated` says. It goes by the first two elements. Empty if they can be read as stated, or in no
/// other way.
[[nodiscard]] std::string contradictingSyntax(const InputFile& file, std::uint64_t start, const DicomWriting& stated);

}  // namespace echolucent
