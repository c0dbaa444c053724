// Where to cut off a wall of tissue that stands in front of the fluid.
#pragma once

#include <optional>
#include <string>

#include "processing/adaptive/adaptive_otf.h"
#include "processing/progress.h"
#include "processing/viewpoint.h"
#include "processing/volume/volume.h"

namespace echolucent {

/// A near cut and how it was found.
struct NearCutSuggestion {
    double nearCutMm = 0.0;   ///< as Viewpoint::nearCutMm; it is 0 where nothing stands in front of the fluid
    int tubesWithWeight = 0;  ///< tube cores whose surface was found and weighs more than 0
    int tubesInFluid = 0;     ///< how many of these have entered fluid at the cut and not reached their surface
    std::string message;      ///< a sentence where nothing can be suggested; else it is empty
};

/// The depth at which most tube cores have entered fluid, measured without the view's own near cut. The
/// result is empty only where the search was cancelled.
[[nodiscard]] std::optional<NearCutSuggestion> suggestNearCut(const Volume& volume, const Viewpoint& view,
                                                              const AdaptiveOtfConfig& config,
                                                              const Progress& progress = {});

}  // namespace echolucent
