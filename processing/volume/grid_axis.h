// The three axes of a voxel grid.
#pragma once

#include <optional>
#include <string_view>

namespace echolucent {

enum class GridAxis { x, y, z };

/// "x", "y", "z".
[[nodiscard]] std::string_view nameOf(GridAxis axis);
[[nodiscard]] std::optional<GridAxis> gridAxisFromName(std::string_view name);

/// 0, 1 or 2: the place of the axis in a Vec3.
[[nodiscard]] constexpr int placeOf(GridAxis axis) { return static_cast<int>(axis); }

}  // namespace echolucent
