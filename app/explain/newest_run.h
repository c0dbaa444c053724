// Whether an explanation is of the curve that the document asks for now.
#pragma once

#include <memory>

#include "app/otf/pane_otfs.h"

namespace echolucent {

/// Whether a run is that of the scene's adaptive OTF, and the document asks for no newer one.
[[nodiscard]] inline bool isNewestRun(const PaneOtfs& otfs, const std::shared_ptr<const AdaptiveOtf>& run) {
    return run && otfs.isNewest(PaneOtfs::adaptiveOfScene) && otfs.adaptive() == run;
}

}  // namespace echolucent
