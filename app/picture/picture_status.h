// The words of the status line on a picture.
#pragma once

#include <QString>
#include <optional>

#include "widgets/volume_view/volume_view_widget.h"

namespace echolucent {

/// Quality, rays, step and cost of the newest picture. If there was a movement, the same and the frame rate of the
/// newest one. Each on its own line.
[[nodiscard]] QString pictureToolTip(const PictureReport& newest, const std::optional<PictureReport>& movement);

}  // namespace echolucent
