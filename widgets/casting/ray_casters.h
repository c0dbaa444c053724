// The ray casters of the panes that are shown, in the casting thread.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "processing/picture/picture_request.h"
#include "processing/progress.h"
#include "processing/ray_caster/sample_use.h"
#include "widgets/casting/cast_picture.h"

namespace echolucent {

/// What casting a request gave.
struct CastResult {
    std::vector<CastPane> panes{};  ///< of all panes; empty if it was cancelled
    /// How samples were used, if all panes that were cast used them alike and the time says what a picture costs: all
    /// panes were sampled, or some were made of kept samples and the others stayed as they were. Else no value.
    std::optional<SampleUse> samples{};
    double lightMilliseconds = 0.0;  ///< of all, for light volumes, whose cost does not depend on the picture's size
};

/// Casts the panes of a request with the request's own settings. It runs in the casting thread, one call at a time. A
/// request without panes gives no picture; whatever was kept of volumes is let go before the call returns.
using Cast = std::function<CastResult(const PictureRequest& request, const Progress& progress)>;

/// Casts each pane through a RayCaster that is kept from picture to picture as long as the pane shows the same scan.
/// Casters of one scan share its packed voxels. A pane of which nothing changed is not cast again.
[[nodiscard]] Cast castThroughRayCasters();

}  // namespace echolucent
