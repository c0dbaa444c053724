#include "widgets/volume_view/scene/picture_request.h"

#include <algorithm>

namespace echolucent {

bool samePicture(const PictureRequest& a, const PictureRequest& b) {
    const bool curveMatters = a.settings.mode == RenderMode::direct;
    return a.volume == b.volume && a.settings == b.settings && (a.curve == b.curve || !curveMatters);
}

ScreenPicture screenPicture(const Picture& picture) {
    ScreenPicture screen{picture.width, picture.height, std::vector<std::uint8_t>(picture.rgba.size()), picture.depthMm,
                         false};
    std::transform(picture.rgba.begin(), picture.rgba.end(), screen.rgba.begin(), [](float value) {
        return static_cast<std::uint8_t>(std::clamp(value, 0.0f, 1.0f) * 255.0f + 0.5f);
    });
    return screen;
}

ScreenPicture screenPicture(const Picture& picture, const RayCastSettings& settings) {
    ScreenPicture screen = screenPicture(picture);
    screen.endsAtOpaqueProps = settings.opaqueDepth != nullptr;
    return screen;
}

}  // namespace echolucent
