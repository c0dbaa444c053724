// Objects of many frames that are kept in several files: DICOM's concatenations (PS3.3 C.7.6.16.2.2.4).
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "processing/result.h"

class DcmItem;

namespace echolucent {

/// Which part of a larger object a file says that it is. What it does not say is empty.
struct ConcatenationPart {
    std::string whole;                   ///< the UID that all parts share; empty if none is stated
    std::optional<std::int64_t> number;  ///< (0020,9162) In-concatenation Number, from 1
    std::optional<std::int64_t> total;   ///< (0020,9163) In-concatenation Total Number
    std::optional<std::int64_t> offset;  ///< (0020,9228) Concatenation Frame Offset Number: frames in earlier parts
    std::int64_t frames = 1;             ///< of this file

    friend bool operator==(const ConcatenationPart&, const ConcatenationPart&) = default;
};

/// What the file says of itself as a part; no value if it is none. With a Concatenation UID it is one if it states its
/// number, its offset or a total above 1. Without that UID it must state its number and such a total.
[[nodiscard]] std::optional<ConcatenationPart> concatenationPartOf(DcmItem& dataset);

/// Whether a part says that it is the only one.
[[nodiscard]] bool isWhole(const ConcatenationPart& part);

/// Whether nothing says that a part is not the only one: it may be the first of several.
[[nodiscard]] bool mayBeWhole(const ConcatenationPart& part);

/// "part 2 of 3".
[[nodiscard]] std::string partInWords(const ConcatenationPart& part);

/// The refusal of a part that was opened by itself.
[[nodiscard]] tl::unexpected<Failure> onlyAPart(const std::string& path, const ConcatenationPart& part);

/// The note on an object that does not say of how many parts it is, `parts` of which are here.
[[nodiscard]] std::string moreMayBeMissing(std::size_t parts);

/// Whether a failure is arrangeParts()'s, so that a file that cannot be read may be what is missing.
[[nodiscard]] bool isAboutParts(const Failure& failure);

/// A file with what it says.
struct PartFile {
    std::string path;
    ConcatenationPart part;
};

/// Parts in their order.
struct ArrangedParts {
    std::vector<std::size_t> order;  ///< indices of the files
    std::vector<std::string> notes;  ///< on what was assumed
};
/// Puts the parts of one object in order: by their numbers, else by their offsets. Fails (unreadable, about `folder`)
/// if a part or frames are missing, naming them; if two files are the same part; and if neither numbers nor offsets are
/// stated. `files` holds at least one.
[[nodiscard]] Result<ArrangedParts> arrangeParts(const std::string& folder, const std::vector<PartFile>& files);

}  // namespace echolucent
