#include "processing/opacity_curve.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace echolucent {

namespace {

constexpr double minusInfinity = -std::numeric_limits<double>::infinity();

double valueOf(const ManualCurve& curve, double x) {
    const auto& nodes = curve.nodes;
    if (nodes.empty()) return 0.0;
    const auto after = std::upper_bound(nodes.begin(), nodes.end(), x,
                                        [](double value, const CurveNode& node) { return value < node.intensity; });
    if (after == nodes.begin()) return nodes.front().opacity;
    if (after == nodes.end()) return nodes.back().opacity;
    const CurveNode& left = *(after - 1);
    const double share = (x - left.intensity) / (after->intensity - left.intensity);
    return left.opacity + share * (after->opacity - left.opacity);
}

double valueOf(const LinearCurve& curve, double x) {
    if (x < curve.lower) return 0.0;
    return curve.slope * (std::min(x, curve.upper) - curve.lower);
}

double valueOf(const PowerCurve& curve, double x) { return curve.scale * std::pow(x, curve.exponent); }

double valueOf(const SampledCurve& curve, double x) {
    const auto& values = curve.opacities;
    if (values.empty()) return 0.0;
    if (values.size() == 1) return values.front();
    const double position = x * static_cast<double>(values.size() - 1);
    const auto left = std::min(static_cast<std::size_t>(position), values.size() - 2);
    const double share = position - static_cast<double>(left);
    return values[left] + share * (values[left + 1] - values[left]);
}

double clampedIntensity(double intensity) { return intensity > 0.0 ? std::min(intensity, 1.0) : 0.0; }

double unclampedOpacity(const OpacityCurve& curve, double intensity) {
    return std::visit([x = clampedIntensity(intensity)](const auto& shape) { return valueOf(shape, x); }, curve);
}

}  // namespace

double opacityAt(const OpacityCurve& curve, double intensity) {
    const double opacity = unclampedOpacity(curve, intensity);
    return opacity > 0.0 ? std::min(opacity, 1.0) : 0.0;
}

std::vector<double> sampledOpacities(const OpacityCurve& curve, int count) {
    if (count < 2) throw std::invalid_argument("sampledOpacities: needs two samples or more");
    std::vector<double> opacities(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i)
        opacities[static_cast<std::size_t>(i)] = opacityAt(curve, static_cast<double>(i) / (count - 1));
    return opacities;
}

double logOpacityAt(const OpacityCurve& curve, double intensity) {
    if (const auto* power = std::get_if<PowerCurve>(&curve)) {
        // Take the logarithm first, since x^4 of a small intensity loses digits or underflows.
        const double x = clampedIntensity(intensity);
        if (!(x > 0.0) || !(power->scale > 0.0)) return minusInfinity;
        return std::log(power->scale) + power->exponent * std::log(x);
    }
    const double opacity = unclampedOpacity(curve, intensity);
    return opacity > 0.0 ? std::log(opacity) : minusInfinity;
}

double opacityForStep(double opacity, double stepRatio) {
    if (!(opacity > 0.0)) return 0.0;
    if (opacity >= 1.0) return stepRatio > 0.0 ? 1.0 : 0.0;
    return -std::expm1(stepRatio * std::log1p(-opacity));
}

}  // namespace echolucent
