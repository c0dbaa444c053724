// Changes of headers of text: MetaImage and NRRD.
#pragma once

#include <cstdint>
#include <string>

namespace echolucent {

/// A MetaImage with up to four changes: keys and their values exchanged, doubled, left out, put in, in another order;
/// values that become extremes, long lists or names of other types; now and then bytes of header or voxels.
[[nodiscard]] std::string mutatedMetaImage(std::string bytes, std::uint64_t seed);
/// The same for an NRRD and its fields.
[[nodiscard]] std::string mutatedNrrd(std::string bytes, std::uint64_t seed);

}  // namespace echolucent
