// How a headerless file is laid out, as its dialog gives it.
#pragma once

#include <QString>
#include <QStringList>
#include <array>
#include <cstdint>
#include <optional>

namespace echolucent {

/// How a headerless file is laid out; the same fields as the reader's.
struct RawLayoutValues {
    std::array<std::int64_t, 3> size{0, 0, 0};  ///< voxels along x (fastest), y, z
    QString type = QStringLiteral("uint8");     ///< one of rawVoxelTypes()
    bool bigEndian = false;
    std::int64_t headerBytes = 0;
    std::array<double, 3> spacing{1, 1, 1};  ///< mm
    bool spacingKnown = false;
    friend bool operator==(const RawLayoutValues&, const RawLayoutValues&) = default;
};

/// uint8, int8, uint16, int16, uint32, int32, float32, float64.
[[nodiscard]] const QStringList& rawVoxelTypes();

/// Bytes of the voxels alone; nothing for a type or size that makes no sense, or beyond 2^63 - 1 bytes.
[[nodiscard]] std::optional<std::int64_t> voxelBytesNeeded(const RawLayoutValues& layout);
/// Bytes of header and voxels; nothing where voxelBytesNeeded() gives nothing, or for a negative header.
[[nodiscard]] std::optional<std::int64_t> bytesNeeded(const RawLayoutValues& layout);

}  // namespace echolucent
