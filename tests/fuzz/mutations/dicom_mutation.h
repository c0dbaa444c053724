// Changes of DICOM files, element by element.
#pragma once

#include <cstdint>
#include <string>

namespace echolucent {

/// A DICOM file with up to four changes: VRs, lengths, values and tags of elements, at any depth; elements that are
/// left out, doubled, exchanged, moved, nested or put in; delimiters that are missing; another transfer syntax;
/// fragments that are left out, doubled, emptied, exchanged or changed; now and then any bytes. Deflated data sets are
/// unpacked, changed and packed again; of big-endian ones any bytes change.
[[nodiscard]] std::string mutatedDicom(std::string bytes, std::uint64_t seed);

}  // namespace echolucent
