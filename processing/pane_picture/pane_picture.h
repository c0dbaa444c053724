// The picture of a document's pane, as the window shows it at rest, without a window.
#pragma once

#include <memory>
#include <optional>
#include <span>

#include "processing/pane_picture/pane_caster.h"
#include "processing/progress.h"
#include "processing/volume/volume.h"

namespace echolucent {

/// PaneCaster::picture() of one pane. `scans`: all phases of the study, as they were read. The pane shows one of them
/// (std::out_of_range if its phase is not among them). Throws std::invalid_argument if there are none. The result is
/// empty only if progress.cancel was raised.
[[nodiscard]] std::optional<PanePicture> panePicture(const Document& document, std::size_t pane,
                                                     std::span<const std::shared_ptr<const Volume>> scans, int width,
                                                     int height, const Progress& progress = {},
                                                     PictureQuality quality = PictureQuality::converged);

}  // namespace echolucent
