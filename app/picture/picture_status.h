// What the status line tells of a picture, in words.
#pragma once

#include <QString>
#include <optional>

#include "widgets/volume_view/volume_view_widget.h"

namespace echolucent {

/// Quality, rays, step and cost of the newest picture, and the same and the frame rate of the newest movement where
/// there was one, each on a line of its own.
[[nodiscard]] QString pictureToolTip(const PictureReport& newest, const std::optional<PictureReport>& movement);

}  // namespace echolucent
