// The words of the status line on a picture.
#pragma once

#include <QString>
#include <optional>

#include "widgets/volume_view/volume_view_widget.h"

namespace echolucent {

/// A line with quality, rays and step of the newest picture, and a line with its times. If `movement` has a frame rate,
/// a third line has this rate and the quality, rays and step of the movement's picture.
[[nodiscard]] QString pictureToolTip(const PictureReport& newest, const std::optional<PictureReport>& movement);

}  // namespace echolucent
