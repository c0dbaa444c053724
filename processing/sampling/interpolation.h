// How to read a volume between its voxel centres.
#pragma once

#include <optional>
#include <string_view>

namespace echolucent {

enum class Interpolation { nearest, trilinear };

/// "nearest", "trilinear".
[[nodiscard]] std::string_view nameOf(Interpolation interpolation);
[[nodiscard]] std::optional<Interpolation> interpolationFromName(std::string_view name);

}  // namespace echolucent
