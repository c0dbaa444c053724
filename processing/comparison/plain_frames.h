// Pictures of a motion's frames, for the flicker of any classification. The pictures are composited as for the other
// measures: simply, and slowly beside the ray caster.
#pragma once

#include <memory>
#include <span>

#include "processing/motion/flicker.h"
#include "processing/progress.h"
#include "processing/volume/volume.h"

namespace echolucent {

/// A renderer of frames of these phases, for one thread at a time. Rays are parallel and `raySpacing` units apart
/// (finite, above 0) across the box of the volume or of the view. Samples lie one unit apart, are trilinear and not
/// shaded. A pixel's three colours are the composited intensity of eq. 3, and its alpha is the ray's opacity. A ray
/// that meets nothing is clear. Near cut, cut surface and box of a frame's view apply. The renderer reports no
/// progress. A picture is empty only if progress.cancel was raised, and what `progress` points to must outlive the
/// renderer. Throws std::invalid_argument if the ray spacing is out of range.
[[nodiscard]] ClassificationRenderer plainFrameRenderer(std::span<const std::shared_ptr<const Volume>> phases,
                                                        double raySpacing = 1.0, const Progress& progress = {});

}  // namespace echolucent
