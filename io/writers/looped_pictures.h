// Pictures of a movie that come again: each frame is made once and kept.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "processing/result.h"

namespace echolucent {

/// 8-bit red, green, blue.
using MoviePicture = std::vector<std::uint8_t>;

/// The most bytes of frames that addLooped() keeps: some 300 frames of 1280 x 720, since they are packed.
inline constexpr std::size_t mostBytesOfLoop = std::size_t{256} << 20;

/// Hands the pictures of a movie to `add`, in turn: `frames` names the frame of each. `make` makes a frame, once: one
/// that comes again is kept, packed without loss, as long as all that are kept take at most `mostBytes`. A frame that
/// has no room there is made anew each time it comes. Fails as `make` and `add` do.
[[nodiscard]] Result<void> addLooped(const std::vector<int>& frames,
                                     const std::function<Result<MoviePicture>(int frame)>& make,
                                     const std::function<Result<void>(std::span<const std::uint8_t> rgb)>& add,
                                     std::size_t mostBytes = mostBytesOfLoop);

}  // namespace echolucent
