// The voxels of a volume as values.
#pragma once

#include <cstdint>
#include <variant>
#include <vector>

namespace echolucent {

/// The voxel types kept in memory. Readers convert every other stored type without loss into one of them where
/// possible (int8/int16 without negative values become unsigned) and say in the import report where it was not.
using Voxels = std::variant<std::vector<std::uint8_t>, std::vector<std::uint16_t>, std::vector<float>>;

}  // namespace echolucent
