#include <array>
#include <utility>

#include "processing/adaptive_otf.h"

namespace echolucent {

namespace {
constexpr std::array<std::pair<MethodReading, std::string_view>, 3> names{{{MethodReading::asPublished, "published"},
                                                                           {MethodReading::settled, "settled"},
                                                                           {MethodReading::standard, "default"}}};
}  // namespace

std::string_view nameOf(MethodReading reading) {
    for (const auto& [value, name] : names)
        if (value == reading) return name;
    return {};
}

std::optional<MethodReading> methodReadingFromName(std::string_view name) {
    for (const auto& [value, known] : names)
        if (known == name) return value;
    return std::nullopt;
}

AdaptiveOtfConfig configOf(MethodReading reading) {
    AdaptiveOtfConfig config;
    if (reading == MethodReading::standard) return config;
    // Every open point by its value: these two stay what they are when the defaults change.
    config.interfaceFunction = InterfaceFunction::variance;
    config.form = CurveForm::product;
    config.cellSize = 5;
    config.coarsestScale = 7;
    config.finestScale = 3;
    config.sigmaPerKernelSize = 0.25;
    config.kernelCut = 3.0;
    config.significance = 0.4;
    config.floorQuantile = 0.0;
    config.cellStride = 1;
    config.border = TubeBorder::mirrorThenZero;
    config.smoothing = SmoothingRoute::direct;
    config.kernelEndsAtZero = false;
    config.coarsestMustHaveMaximum = true;
    config.trackingRangeSigmas = 0.0;
    config.priorCellsMayOverlap = false;
    config.rankBins = 0;
    config.slopeHalfStep = 5;
    config.leastEdgeToNoise = 0.0;
    config.lowReach = 0;
    config.highReach = 0;
    // d_max = 0.03 at the paper's 225 tube cores. A d_max that stays 0.03 at any T would be a strength of 0.03 T; at
    // 225 both are the same.
    constexpr double dMaxOfThePaperGrid = 0.03;
    constexpr int tubesOfThePaperGrid = 225;
    config.strength = dMaxOfThePaperGrid * tubesOfThePaperGrid;
    config.initial = PowerCurve{2, 1.0};
    if (reading == MethodReading::settled) return config;
    config.border = TubeBorder::circular;
    config.smoothing = SmoothingRoute::fourier;
    config.trackingRangeSigmas = 2.0;
    config.significance = 0.0;
    config.priorCellsMayOverlap = true;
    config.rankBins = 256;
    return config;
}

std::optional<MethodReading> readingOf(const AdaptiveOtfConfig& config) {
    for (const auto& [reading, name] : names) {
        AdaptiveOtfConfig known = configOf(reading);
        known.tubeColumns = config.tubeColumns;
        known.tubeRows = config.tubeRows;
        known.tubeSpacing = config.tubeSpacing;
        known.initial = config.initial;
        if (known == config) return reading;
    }
    return std::nullopt;
}

}  // namespace echolucent
