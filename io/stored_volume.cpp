#include "io/stored_volume.h"

namespace echolucent {

Result<ByteCounts> countBytes(const StoredVolume& stored) {
    if (auto few = requirePhases(stored.path, stored.sizeKey, stored.phases); !few) return tl::unexpected(few.error());
    std::optional<std::int64_t> bytes = bytesOf(stored.type) * stored.channels;
    for (const std::int64_t size : stored.geometry.size) bytes = bytes ? checkedProduct(*bytes, size) : bytes;
    const auto all = bytes ? checkedProduct(*bytes, stored.phases) : bytes;
    if (!all)
        return fail(FailureKind::unreadable, stored.path, stored.sizeKey,
                    "declares more voxels than any file can hold (" + sizeText(stored.geometry.size) + ")",
                    stored.sizeRemedy);
    return ByteCounts{*bytes, *all};
}

}  // namespace echolucent
