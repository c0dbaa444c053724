// Changes of headers of text: MetaImage and NRRD.
#pragma once

#include <cstdint>
#include <string>

namespace echolucent {

/// A MetaImage with up to four changes. Keys and their values are exchanged, doubled, left out, put in or reordered.
/// Values become extremes, long lists or names of other types. Now and then bytes of header or voxels change.
[[nodiscard]] std::string mutatedMetaImage(std::string bytes, std::uint64_t seed);
/// The same for an NRRD and its fields.
[[nodiscard]] std::string mutatedNrrd(std::string bytes, std::uint64_t seed);

}  // namespace echolucent
