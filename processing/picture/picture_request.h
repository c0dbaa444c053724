// What pictures of panes are made from.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "processing/classification.h"
#include "processing/picture/ray_cast_settings.h"
#include "processing/volume/volume.h"

namespace echolucent {

/// What one pane is cast through.
struct PaneRequest {
    std::shared_ptr<const Volume> volume;
    Classification classification{};
    std::size_t pane = 0;  ///< its place in the document
    friend bool operator==(const PaneRequest&, const PaneRequest&) = default;
};

/// One to four panes that share camera, look and size. A value, so that it may cross threads.
struct PictureRequest {
    std::vector<PaneRequest> panes{};
    RayCastSettings settings{};  ///< at the panes' full size
};

/// True if both show the same panes with the same pixels. Classifications count in direct mode only. Volumes are the
/// same if they are one object.
[[nodiscard]] bool samePicture(const PictureRequest& one, const PictureRequest& other);
/// True if both cast through the same volumes.
[[nodiscard]] bool sameVolumes(const PictureRequest& one, const PictureRequest& other);
/// True if both have the same volumes, and settings that differ in the colour map at most: they are made of the same
/// samples.
[[nodiscard]] bool sameSamples(const PictureRequest& one, const PictureRequest& other);

}  // namespace echolucent
