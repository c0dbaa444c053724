#include "io/stored/stored_volume.h"

#include <algorithm>

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

std::uint64_t memoryToRead(const StoredVolume& stored, const ByteCounts& counts) {
    const auto all = static_cast<double>(counts.all);
    const double voxels = all / static_cast<double>(bytesOf(stored.type) * stored.channels);
    const double onePhase = 1.0 / static_cast<double>(stored.phases);
    const bool staysAsItIs = stored.type == StoredType::uint8 && !stored.rescale;
    const bool isShort = stored.type == StoredType::uint16 && !stored.rescale;
    // Phase by phase, voxels take the place of bytes, which are freed.
    const double kept = voxels * (staysAsItIs ? 1 : isShort ? 2 : 4);
    const double converting = staysAsItIs ? all : std::max(all + kept * onePhase, kept + all * onePhase);
    const double apart = stored.phasesFastest ? 2 * all : 0;
    constexpr double countable = 9e18;
    return stored.unpackedBytes +
           static_cast<std::uint64_t>(std::min(countable, std::max({converting, apart, kept + voxels})));
}

}  // namespace echolucent
