#include "widgets/dialogs/raw_layout.h"

#include <limits>
#include <string_view>

namespace echolucent {
namespace {

/// Bytes of one voxel; 0 for an unknown type.
std::int64_t bytesOf(std::string_view type) {
    if (type == "uint8" || type == "int8") return 1;
    if (type == "uint16" || type == "int16") return 2;
    if (type == "uint32" || type == "int32" || type == "float32") return 4;
    return type == "float64" ? 8 : 0;
}

}  // namespace

const QStringList& rawVoxelTypes() {
    static const QStringList types{"uint8", "int8", "uint16", "int16", "uint32", "int32", "float32", "float64"};
    return types;
}

std::optional<std::int64_t> voxelBytesNeeded(const RawLayout& layout) {
    std::int64_t bytes = bytesOf(layout.type);
    if (bytes == 0) return std::nullopt;
    for (const std::int64_t voxels : layout.size) {
        if (voxels < 1 || bytes > std::numeric_limits<std::int64_t>::max() / voxels) return std::nullopt;
        bytes *= voxels;
    }
    return bytes;
}

std::optional<std::int64_t> bytesNeeded(const RawLayout& layout) {
    const auto voxelBytes = voxelBytesNeeded(layout);
    if (!voxelBytes || layout.headerBytes < 0) return std::nullopt;
    if (layout.headerBytes > std::numeric_limits<std::int64_t>::max() - *voxelBytes) return std::nullopt;
    return layout.headerBytes + *voxelBytes;
}

}  // namespace echolucent
