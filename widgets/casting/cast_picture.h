// The pictures of panes, on their way from the casting thread to the screen.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "processing/picture/picture.h"
#include "processing/picture/picture_request.h"
#include "processing/picture/screen_picture.h"
#include "widgets/casting/qualities.h"

namespace echolucent {

struct CardPicture;
struct KnownCardPicture;

/// The finished picture of one pane, or what a graphics card draws it from.
struct CastPane {
    std::shared_ptr<const Picture> picture{};  ///< null if the pane is one of several, or comes from kept frames
    std::shared_ptr<const ScreenPicture> screen{};
    double milliseconds = 0.0;  ///< wall time in the casting thread, light included
    bool sampled = true;        ///< false: made of kept samples, which takes less time
    /// If the card draws, these are set, and picture and screen are null.
    std::shared_ptr<const CardPicture> card{};
    std::shared_ptr<const KnownCardPicture> known{};
};

/// The pictures of all panes of a request, and what they were made from.
struct CastPicture {
    PictureRequest request;         ///< as it was asked for, at full size
    std::size_t quality = 0;        ///< an index into `qualities`
    RayCastSettings settings;       ///< those of `quality`
    std::vector<CastPane> panes{};  ///< as in the request
    double milliseconds = 0.0;      ///< wall time of all panes in the casting thread
    bool followsHand = false;       ///< the quick picture of its request, not one that refines it
    bool byCard = false;            ///< the graphics card draws
    [[nodiscard]] bool converged() const { return quality == convergedQuality; }
};

}  // namespace echolucent
