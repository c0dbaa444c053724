// The number of bytes of a headerless file.
#pragma once

#include <QStringList>
#include <cstdint>
#include <optional>

#include "processing/document/read_options.h"

namespace echolucent {

/// uint8, int8, uint16, int16, uint32, int32, float32, float64.
[[nodiscard]] const QStringList& rawVoxelTypes();

/// Bytes of the voxels alone. No value for an impossible type or size, or beyond 2^63 - 1 bytes.
[[nodiscard]] std::optional<std::int64_t> voxelBytesNeeded(const RawLayout& layout);
/// Bytes of header and voxels. No value if voxelBytesNeeded() has none, or for a negative header.
[[nodiscard]] std::optional<std::int64_t> bytesNeeded(const RawLayout& layout);

}  // namespace echolucent
