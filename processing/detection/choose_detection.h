// From a detection rule to the detection that follows it.
#pragma once

#include <memory>
#include <span>

#include "processing/detection/detection.h"
#include "processing/tube_core/rules/detection_rule.h"

namespace echolucent {

/// `samples` are those of all tube cores of the view, `cellSize` is the edge of their cells in units.
[[nodiscard]] std::unique_ptr<Detection> detectionOf(const DetectionRule& rule, std::span<const TubeSamples> samples,
                                                     int cellSize);

}  // namespace echolucent
