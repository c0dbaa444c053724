// Pictures of a motion's frames, for the flicker of any classification. They are composited like the other measures:
// simply, and slowly beside the ray caster.
#pragma once

#include <memory>
#include <span>

#include "processing/motion/flicker.h"
#include "processing/progress.h"
#include "processing/volume/volume.h"

namespace echolucent {

/// A renderer of frames of these phases, for one thread at a time. Rays are parallel and `raySpacing` units apart
/// (finite, above 0) across the box of the volume or of the view. Samples lie one unit apart, are trilinear and not
/// shaded. A pixel's three colours are the composited intensity of eq. 3. A ray that meets nothing is clear. Near cut,
/// cut surface and box of a frame's view apply. A picture is empty only if progress.cancel was raised. Throws
/// std::invalid_argument for another ray spacing.
[[nodiscard]] ClassificationRenderer plainFrameRenderer(std::span<const std::shared_ptr<const Volume>> phases,
                                                        double raySpacing = 1.0, const Progress& progress = {});

}  // namespace echolucent
