#include "processing/adaptive/method_reading.h"

#include "processing/choice_names.h"

namespace echolucent {

namespace {
constexpr ChoiceNames<4> methodReadingNames{"published", "settled", "0.1", "default"};
}  // namespace

std::string_view nameOf(MethodReading reading) { return nameIn(methodReadingNames, reading); }

std::optional<MethodReading> methodReadingFromName(std::string_view name) {
    return choiceNamed<MethodReading>(methodReadingNames, name);
}

AdaptiveOtfConfig configOf(MethodReading reading) {
    AdaptiveOtfConfig config;
    if (reading == MethodReading::standard) return config;
    if (reading == MethodReading::firstVersion) {
        std::get<RampRule>(config.curve).aim = 0.0;
        return config;
    }
    // These two readings spell out every open point and all numerics, so that they stay the same if defaults change.
    VarianceRule variance{.coarsestScale = 7,
                          .finestScale = 3,
                          .sigmaPerKernelSize = 0.25,
                          .kernelCut = 3.0,
                          .kernelEndsAtZero = false,
                          .border = TubeBorder::mirrorThenZero,
                          .smoothing = SmoothingRoute::direct,
                          .significance = 0.4,
                          .floorQuantile = 0.0,
                          .trackingRangeSigmas = 0.0,
                          .coarsestMustHaveMaximum = true,
                          .leastEdgeToNoise = 0.0};
    config.cells = {.size = 5, .sampling = Interpolation::trilinear, .precision = Precision::single32};
    config.surface = {.lowReach = 0, .highReach = 0, .slopeHalfStep = 5, .priorCellsMayOverlap = false};
    config.weights = {.rankBins = 0};
    // d_max = 0.03 at the paper's 225 tube cores. A d_max of 0.03 at any T would be a strength of 0.03 T; at 225 both
    // are equal.
    config.curve = ProductRule{.strength = paperStrength};
    config.initial = PowerCurve{2, 1.0};
    if (reading == MethodReading::asPublished) {
        variance.border = TubeBorder::circular;
        variance.smoothing = SmoothingRoute::fourier;
        variance.trackingRangeSigmas = 2.0;
        variance.significance = 0.0;
        config.surface.priorCellsMayOverlap = true;
        config.weights.rankBins = 256;
    }
    config.detection = variance;
    return config;
}

std::optional<MethodReading> readingOf(const AdaptiveOtfConfig& config) {
    for (const MethodReading reading :
         {MethodReading::asPublished, MethodReading::settled, MethodReading::firstVersion, MethodReading::standard}) {
        AdaptiveOtfConfig known = configOf(reading);
        known.grid = config.grid;
        known.initial = config.initial;
        if (known == config) return reading;
    }
    return std::nullopt;
}

}  // namespace echolucent
