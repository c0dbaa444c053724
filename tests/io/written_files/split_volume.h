// A volume of 2 x 3 x 4 big-endian words. Its voxels lie in several data files or are written as text.
#pragma once

#include <cstdint>
#include <numeric>
#include <string>
#include <vector>

#include "temporary_folder.h"

namespace echolucent {

/// Its NRRD header, with these fields at the end.
inline std::string splitNrrd(const std::string& fields) {
    return "NRRD0004\ntype: ushort\nendian: big\ndimension: 3\nsizes: 2 3 4\nspacings: 1 2 3\n" + fields;
}

/// Its MetaImage header, with these keys at the end.
inline std::string splitMetaImage(const std::string& keys) {
    return "NDims = 3\nDimSize = 2 3 4\nElementSpacing = 1 2 3\nElementType = MET_USHORT\n"
           "BinaryDataByteOrderMSB = True\n" +
           keys;
}

/// Its voxels: the numbers from 1 to 24.
inline std::string splitVoxels() {
    std::vector<std::uint16_t> values(24);
    std::iota(values.begin(), values.end(), std::uint16_t{1});
    return bytesFrom(values, true);
}

/// The same voxels as text, in every form that a number may have.
inline const std::string splitVoxelsAsText =
    "1 2 3 4 5 6\n7, 8,9 , 10 11 12\r\n13 14 15 16 17 18\n19 20 2.1e1 22.0 +23 24";

}  // namespace echolucent
