#include "widgets/volume_view/scene/picture_request.h"

#include <algorithm>
#include <tuple>

namespace echolucent {

namespace {

auto asTuple(const ViewFrame& frame) { return std::tie(frame.right, frame.down, frame.forward); }

bool sameCamera(const Camera& a, const Camera& b) {
    return a.focalPoint == b.focalPoint && asTuple(a.frame) == asTuple(b.frame) && a.projection == b.projection &&
           a.heightMm == b.heightMm && a.viewAngleDegrees == b.viewAngleDegrees && a.distanceMm == b.distanceMm;
}

bool sameSettings(const RayCastSettings& a, const RayCastSettings& b) {
    return a.width == b.width && a.height == b.height && sameCamera(a.camera, b.camera) &&
           a.nearPlaneDepthMm == b.nearPlaneDepthMm && a.step == b.step && a.interpolation == b.interpolation &&
           a.colourMap == b.colourMap && a.shading == b.shading &&
           a.terminationTransmittance == b.terminationTransmittance;
}

}  // namespace

bool samePicture(const PictureRequest& a, const PictureRequest& b) {
    return a.volume == b.volume && sameSettings(a.settings, b.settings) && a.curve == b.curve;
}

ScreenPicture screenPicture(const Picture& picture) {
    ScreenPicture screen{picture.width, picture.height, std::vector<std::uint8_t>(picture.rgba.size())};
    std::transform(picture.rgba.begin(), picture.rgba.end(), screen.rgba.begin(), [](float value) {
        return static_cast<std::uint8_t>(std::clamp(value, 0.0f, 1.0f) * 255.0f + 0.5f);
    });
    return screen;
}

}  // namespace echolucent
