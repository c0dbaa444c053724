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

/// The result of casting a request.
struct CastResult {
    std::vector<CastPane> panes{};  ///< of all panes; empty if the work was cancelled
    /// How the panes that were cast used samples. No value if none was cast, or if they used samples in different ways.
    /// No value either if a pane stayed while others took new samples, because the time then does not tell a picture's
    /// cost.
    std::optional<SampleUse> samples{};
    double castShare = 1.0;          ///< RayCaster::castShare(), the mean of the panes that were cast
    double lightMilliseconds = 0.0;  ///< for all panes' light volumes; independent of the picture's size
};

/// Casts the panes of a request with the request's own settings. It runs in the casting thread, one call at a time. A
/// request without panes gives no picture and frees whatever was kept of volumes before the call returns.
using Cast = std::function<CastResult(const PictureRequest& request, const Progress& progress)>;

/// Casts each pane through a RayCaster, which is kept as long as the pane shows the same scan. Casters of one scan
/// share its packed voxels. Among several panes, a pane is not cast again if nothing changed since its last cast,
/// quality included.
[[nodiscard]] Cast castThroughRayCasters();

}  // namespace echolucent
