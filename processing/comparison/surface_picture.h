// Which pixels of a picture stand for which ray whose surface is known.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "processing/comparison/surface_rays.h"
#include "processing/picture/camera.h"
#include "processing/viewpoint/view_frame.h"

namespace echolucent {

/// Rays of a view in rows and columns. Each stands for a rectangle across the view around its surface.
struct SurfaceRectangles {
    std::vector<SurfaceRay> rays{};
    ViewFrame frame{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};  ///< of the view
    std::array<double, 2> sidesMm{1, 1};               ///< of each rectangle, along the frame's right and down, above 0
};

/// What a pixel shows that no ray stands for.
inline constexpr std::int32_t noRay = -1;
/// The place among the rays whose rectangle is seen at the centre of each pixel, or noRay; row-major from the top left,
/// width x height pixels. A parallel camera along the view sees each rectangle in one size and none behind another: the
/// rays of a shown depth take pixels in proportion to their number, but for those that the picture cuts off. In
/// perspective the nearer rectangle is seen.
[[nodiscard]] std::vector<std::int32_t> raysInPicture(const Camera& camera, int width, int height,
                                                      const SurfaceRectangles& rectangles);

}  // namespace echolucent
