// How to read a volume between its voxel centres.
#pragma once

#include <optional>
#include <string_view>

namespace echolucent {

enum class Interpolation { nearest, trilinear };

/// "nearest", "trilinear".
[[nodiscard]] std::string_view nameOf(Interpolation interpolation);

}  // namespace echolucent
