// Changes of NIfTI headers, field by field.
#pragma once

#include <cstdint>
#include <string>

namespace echolucent {

/// A NIfTI file with up to four changes: fields of its header of 348 or 540 bytes that become extremes of their own
/// types, in the header's order of bytes; now and then the header's version, extensions or any bytes.
[[nodiscard]] std::string mutatedNifti(std::string bytes, std::uint64_t seed);

}  // namespace echolucent
