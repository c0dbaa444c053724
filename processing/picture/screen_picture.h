// A picture in the form that screens take.
#pragma once

#include <cstdint>
#include <vector>

#include "processing/picture/picture.h"

namespace echolucent {

/// 8 bits a component: red, green, blue premultiplied by alpha, row-major from the top left.
struct ScreenPicture {
    int width = 0, height = 0;
    std::vector<std::uint8_t> rgba;
    /// Picture::depthMm, for VTK's depth buffer; empty if the picture has none.
    std::vector<float> depthMm{};
};

/// Rounds each component to the nearest of 256 levels.
[[nodiscard]] ScreenPicture screenPicture(const Picture& picture);

}  // namespace echolucent
