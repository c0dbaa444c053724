// What a picture is made from, and the picture in the form the screen takes.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "processing/classification.h"
#include "processing/picture/picture.h"
#include "processing/picture/ray_cast_settings.h"
#include "processing/volume/volume.h"

namespace echolucent {

/// Everything castRays() needs, as values and shared constants: may cross threads.
struct PictureRequest {
    std::shared_ptr<const Volume> volume;
    Classification classification;
    RayCastSettings settings;
};

/// True where both give the same pixels (the same volume by identity).
[[nodiscard]] bool samePicture(const PictureRequest& a, const PictureRequest& b);

/// A finished picture as the screen takes it: 8 bits a component, red, green, blue premultiplied by alpha, row-major
/// from the top left.
struct ScreenPicture {
    int width = 0, height = 0;
    std::vector<std::uint8_t> rgba;
    /// Picture::depthMm, which VTK's depth buffer is told about the volume; empty where it is told nothing.
    std::vector<float> depthMm{};
};

/// Rounds each component to the nearest of 256 levels.
[[nodiscard]] ScreenPicture screenPicture(const Picture& picture);

}  // namespace echolucent
