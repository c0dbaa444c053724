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

/// Looks at the first two elements of the data set that begins at byte `start`. Empty if they can be written as
/// `stated` says. Else the transfer syntax (UID) of uncompressed pixels that fits them; empty too if none does.
[[nodiscard]] std::string contradictingSyntax(const InputFile& file, std::uint64_t start, const DicomWriting& stated);

}  // namespace echolucent
