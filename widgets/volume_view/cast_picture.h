// A picture of the 3D view, on its way from the casting thread to the screen.
#pragma once

#include <cstddef>
#include <memory>

#include "widgets/volume_view/qualities.h"
#include "widgets/volume_view/scene/picture_request.h"

namespace echolucent {

/// A finished picture with what it was made from.
struct CastPicture {
    PictureRequest request;                    ///< as it was asked for, at full size
    std::size_t quality = 0;                   ///< of qualities
    RayCastSettings settings;                  ///< those of the quality
    std::shared_ptr<const Picture> picture{};  ///< null where the picture comes from the frames kept, or is live
    std::shared_ptr<const ScreenPicture> screen{};
    double milliseconds = 0.0;  ///< wall time in the casting thread
    bool followsHand = false;   ///< the quick one of its request, not one that refines it
    bool live = false;          ///< the graphics card draws: there is no picture here
    [[nodiscard]] bool converged() const { return quality == convergedQuality; }
};

}  // namespace echolucent
