// The ray caster of the volume that is shown, in the casting thread.
#pragma once

#include <functional>
#include <optional>

#include "processing/progress.h"
#include "processing/ray_caster/sample_use.h"
#include "widgets/volume_view/scene/picture_request.h"

namespace echolucent {

struct CastResult {
    std::optional<Picture> picture;  ///< none where it was cancelled
    SampleUse samples = SampleUse::taken;
    double lightMilliseconds =
        0.0;  ///< of the whole, for the light volume, which costs the same for any picture's size
};

/// Casts a picture with the request's own settings. Runs in the casting thread, one call at a time. A request without a
/// volume gives no picture; whatever was kept of volumes is let go before it returns.
using Cast = std::function<CastResult(const PictureRequest& request, const Progress& progress)>;

/// Casts through a RayCaster that is kept from picture to picture as long as the volume stays the same; that of the
/// volume before is let go before the next one is made.
[[nodiscard]] Cast castThroughOneRayCaster();

/// True where the pictures differ in curve and colour map at most, so that they are made of the same samples.
[[nodiscard]] bool sameSamples(const PictureRequest& a, const PictureRequest& b);

}  // namespace echolucent
