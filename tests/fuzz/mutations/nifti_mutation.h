// Changes of NIfTI headers, field by field.
#pragma once

#include <cstdint>
#include <string>

namespace echolucent {

/// A NIfTI file with up to four changes. Fields of its header of 348 or 540 bytes become extremes of their own types,
/// in the header's byte order. Now and then the header's version, extensions or any bytes change.
[[nodiscard]] std::string mutatedNifti(std::string bytes, std::uint64_t seed);

}  // namespace echolucent
