// The values that writers store: the file's own, in a type that holds them.
#pragma once

#include <cstdint>
#include <functional>
#include <span>

#include "io/voxels/voxel_types.h"
#include "processing/volume/volume.h"

namespace echolucent {

/// The type in which the file's own values of a volume are written: that of the voxels if they are these values. Else
/// int16 or int32 for whole numbers above a whole black, and float64 for all others.
[[nodiscard]] StoredType typeOfFileValues(const Volume& volume);

/// Hands over the bytes of all voxels' own values, in typeOfFileValues() and this machine's byte order, in blocks.
void addFileValues(const Volume& volume, const std::function<void(std::span<const std::uint8_t>)>& add);

/// Whether volumes can lie in one file: they have one size, type and scale.
[[nodiscard]] bool canBeWrittenTogether(const Volume& one, const Volume& other);

}  // namespace echolucent
