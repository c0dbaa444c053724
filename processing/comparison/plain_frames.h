// Pictures of a motion's frames for the flicker of any classification, composited as the other measures are: plain and
// slow beside the ray caster.
#pragma once

#include <memory>
#include <span>

#include "processing/motion/flicker.h"
#include "processing/progress.h"
#include "processing/volume/volume.h"

namespace echolucent {

/// A renderer of frames of these phases, for one thread at a time. Rays are parallel and `raySpacing` units apart
/// (finite, above 0) across the box of the volume or of the view; their samples lie one unit apart, are trilinear and
/// not shaded. A pixel's three colours are the composited intensity of eq. 3, a ray that meets nothing is clear. Near
/// cut, cut surface and box of a frame's view are kept. A picture is empty only where progress.cancel was raised.
/// Throws std::invalid_argument for another ray spacing.
[[nodiscard]] ClassificationRenderer plainFrameRenderer(std::span<const std::shared_ptr<const Volume>> phases,
                                                        double raySpacing = 1.0, const Progress& progress = {});

}  // namespace echolucent
