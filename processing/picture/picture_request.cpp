#include "processing/picture/picture_request.h"

#include <algorithm>

namespace echolucent {

bool sameVolumes(const PictureRequest& one, const PictureRequest& other) {
    return std::ranges::equal(one.panes, other.panes, {}, &PaneRequest::volume, &PaneRequest::volume);
}

bool samePicture(const PictureRequest& one, const PictureRequest& other) {
    if (one.settings != other.settings) return false;
    const bool opacityMatters = one.settings.mode == RenderMode::direct;
    return std::ranges::equal(one.panes, other.panes, [&](const PaneRequest& a, const PaneRequest& b) {
        return a.volume == b.volume && a.pane == b.pane && (!opacityMatters || a.classification == b.classification);
    });
}

bool sameSamples(const PictureRequest& one, const PictureRequest& other) {
    RayCastSettings recoloured = one.settings;
    recoloured.colourMap = other.settings.colourMap;
    return sameVolumes(one, other) && recoloured == other.settings;
}

}  // namespace echolucent
