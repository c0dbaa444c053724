#include "processing/detection/choose_detection.h"

#include "processing/detection/detection_by_ratio.h"
#include "processing/detection/detection_by_variance.h"

namespace echolucent {

std::unique_ptr<Detection> detectionOf(const DetectionRule& rule, std::span<const TubeSamples> samples, int cellSize) {
    if (const auto* variance = std::get_if<VarianceRule>(&rule))
        return std::make_unique<DetectionByVariance>(*variance, samples.size(), cellSize);
    return std::make_unique<DetectionByRatio>(std::get<RatioRule>(rule), samples, cellSize);
}

}  // namespace echolucent
