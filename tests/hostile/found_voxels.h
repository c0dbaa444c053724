// Finds out, without any reader of this program, whether voxels that were read stand in a file.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "good_files.h"

namespace echolucent {

/// Voxels in an uncompressed MetaImage that echolucent-cli quiet wrote.
struct WrittenVoxels {
    std::string type;  ///< "MET_UCHAR", "MET_USHORT", "MET_FLOAT" or "MET_DOUBLE"
    std::array<std::int64_t, 3> size{};
    std::string bytes;  ///< little endian, x fastest
};

/// The volume of such a file; no value if it is none.
[[nodiscard]] std::optional<WrittenVoxels> writtenVoxels(const std::string& path);

/// Whether the voxels, in one of the number types of files, stand in one of `places`: as one run of bytes, or slice by
/// slice. If some are said to be missing, zeros may stand in for them: at the end, or as a whole slice beside one that
/// is found.
[[nodiscard]] bool standIn(const WrittenVoxels& voxels, const std::vector<std::string>& places, bool someAreMissing);

/// Where the voxels of a good file may stand after its files became `changed` (in their order): the files' bytes, their
/// digits, their unpacked contents, or what was written. Empty if none of these gives the voxels. That is so if the
/// codestreams of a picture codec without a checksum were changed, or if voxels are interpolated.
[[nodiscard]] std::vector<std::string> placesOfVoxels(const GoodFile& good, const std::vector<std::string>& changed);

}  // namespace echolucent
