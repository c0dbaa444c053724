// The picture of a view of a document, by itself: what a window shows of it at rest, without a window.
#pragma once

#include <memory>
#include <optional>
#include <span>

#include "processing/document/view_caster.h"
#include "processing/progress.h"
#include "processing/volume/volume.h"

namespace echolucent {

/// The picture of a view. `scans`: all phases of the study, as they were read; the view shows one of them
/// (std::out_of_range where there are not so many). The strokes cut raw and quiet voxels; the adaptive curve is
/// computed from raw ones along otfViewpointOf(), in direct mode and where the view is rendered with it: those of the
/// phase shown, or of otfPhaseOf(), where one OTF is chosen for all phases. The result is empty only where
/// progress.cancel was raised.
[[nodiscard]] std::optional<ViewPicture> viewPicture(const Document& document, std::size_t pane,
                                                     std::span<const std::shared_ptr<const Volume>> scans, int width,
                                                     int height, const Progress& progress = {},
                                                     PictureQuality quality = PictureQuality::converged);

}  // namespace echolucent
