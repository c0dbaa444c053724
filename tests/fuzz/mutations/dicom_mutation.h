// Changes of DICOM files, element by element.
#pragma once

#include <cstdint>
#include <string>

namespace echolucent {

/// A DICOM file with up to four changes. VRs, lengths, values and tags of elements change at any depth. Elements are
/// left out, doubled, exchanged, moved, nested or put in. Delimiters go missing. The transfer syntax changes. Fragments
/// are left out, doubled, emptied, exchanged or changed. Now and then any bytes change. Deflated data sets are
/// unpacked, changed and packed again. In big-endian ones any bytes change.
[[nodiscard]] std::string mutatedDicom(std::string bytes, std::uint64_t seed);

}  // namespace echolucent
