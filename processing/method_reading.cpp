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
    config.interfaceFunction = InterfaceFunction::variance;
    config.form = CurveForm::product;
    config.strength = 6.75;
    config.lowReach = 0;
    config.highReach = 0;
    config.floorQuantile = 0.0;
    config.leastEdgeToNoise = 0.0;
    config.kernelEndsAtZero = false;
    config.coarsestMustHaveMaximum = true;
    if (reading == MethodReading::settled) return config;
    config.border = TubeBorder::circular;
    config.smoothing = SmoothingRoute::fourier;
    config.trackingRangeSigmas = 2.0;
    config.significance = 0.0;
    config.priorCellsMayOverlap = true;
    config.rankBins = 256;
    return config;
}

}  // namespace echolucent
