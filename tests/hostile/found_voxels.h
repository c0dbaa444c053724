// Whether voxels that were read stand in a file, found without any reader of this program.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "good_files.h"

namespace echolucent {

/// Voxels as echolucent-cli quiet wrote them into an uncompressed MetaImage.
struct WrittenVoxels {
    std::string type;  ///< "MET_UCHAR", "MET_USHORT" or "MET_FLOAT"
    std::array<std::int64_t, 3> size{};
    std::string bytes;  ///< little endian, x fastest
};

/// The volume of such a file; no value where it is none.
[[nodiscard]] std::optional<WrittenVoxels> writtenVoxels(const std::string& path);

/// Whether the voxels, in one of the number types that files hold them in, stand in one of `places` as one run of
/// bytes, or each slice of them does. Where some are said to be missing, zeros at their end, or a slice of nothing but
/// zeros beside one that stands, count as these.
[[nodiscard]] bool standIn(const WrittenVoxels& voxels, const std::vector<std::string>& places, bool someAreMissing);

/// Where the voxels of a good file may stand once its files were changed to `changed` (in their order): the bytes of
/// these files, what their digits say, what they unpack to, or what was written. It is empty where none of that says
/// what the voxels are: a picture codec without a checksum whose codestreams were changed, or voxels that are
/// interpolated.
[[nodiscard]] std::vector<std::string> placesOfVoxels(const GoodFile& good, const std::vector<std::string>& changed);

}  // namespace echolucent
