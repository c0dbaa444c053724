#include "processing/classification.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>

namespace echolucent {

namespace {

constexpr int fewestOtfNodes = 2, mostOtfNodes = 1024;

/// A value's place between nodes: the node before it, and the share of the way to the next node.
struct BetweenNodes {
    std::size_t before;
    double share;

    BetweenNodes(double value, int nodes) {
        // Written so that NaN becomes 0.
        const double inside = value > 0.0 ? std::min(value, 1.0) : 0.0;
        const double position = inside * (nodes - 1);
        before = std::min(static_cast<std::size_t>(position), static_cast<std::size_t>(nodes - 2));
        share = position - static_cast<double>(before);
    }
};

}  // namespace

void classification_detail::check(int intensities, int gradients, double largestGradient) {
    const auto isNumber = [](int nodes) { return nodes >= fewestOtfNodes && nodes <= mostOtfNodes; };
    if (!isNumber(intensities) || !isNumber(gradients))
        throw std::invalid_argument("TwoDimensionalOtf: nodes along an axis must be 2 to 1024");
    if (!(std::isfinite(largestGradient) && largestGradient > 0.0))
        throw std::invalid_argument("TwoDimensionalOtf: the largest gradient must be above 0");
}

float classification_detail::clampedOpacity(double opacity) {
    return opacity > 0.0 ? static_cast<float>(std::min(opacity, 1.0)) : 0.0f;
}

double opacityAt(const TwoDimensionalOtf& otf, double intensity, double gradient) {
    const BetweenNodes f(intensity, otf.intensities), g(gradient / otf.largestGradient, otf.gradients);
    const auto row = [&](std::size_t node) {
        const float* const from = otf.opacities.data() + node * static_cast<std::size_t>(otf.intensities) + f.before;
        const auto left = static_cast<double>(from[0]), right = static_cast<double>(from[1]);
        return left + f.share * (right - left);
    };
    const double low = row(g.before), high = row(g.before + 1);
    return low + g.share * (high - low);
}

Classification::Classification(TwoDimensionalOtf otf) {
    classification_detail::check(otf.intensities, otf.gradients, otf.largestGradient);
    if (otf.opacities.size() != static_cast<std::size_t>(otf.intensities) * static_cast<std::size_t>(otf.gradients))
        throw std::invalid_argument("TwoDimensionalOtf: there must be one opacity a node");
    if (!std::ranges::all_of(otf.opacities, [](float opacity) { return opacity >= 0.0f && opacity <= 1.0f; }))
        throw std::invalid_argument("TwoDimensionalOtf: opacities must be within 0 and 1");
    m_twoDimensional = std::make_shared<const TwoDimensionalOtf>(std::move(otf));
}

bool operator==(const Classification& one, const Classification& other) {
    if (one.isTwoDimensional() != other.isTwoDimensional()) return false;
    if (!one.isTwoDimensional()) return one.m_curve == other.m_curve;
    return one.m_twoDimensional == other.m_twoDimensional || *one.m_twoDimensional == *other.m_twoDimensional;
}

double opacityAt(const Classification& classification, double intensity, double gradient) {
    if (classification.isTwoDimensional()) return opacityAt(*classification.twoDimensional(), intensity, gradient);
    return opacityAt(classification.curve(), intensity);
}

OpacityCurve upperCurveOf(const Classification& classification) {
    if (!classification.isTwoDimensional()) return classification.curve();
    const TwoDimensionalOtf& otf = *classification.twoDimensional();
    const auto columns = static_cast<std::size_t>(otf.intensities);
    SampledCurve upper{std::vector<double>(columns, 0.0)};
    for (std::size_t node = 0; node < otf.opacities.size(); ++node)
        upper.opacities[node % columns] =
            std::max(upper.opacities[node % columns], static_cast<double>(otf.opacities[node]));
    return upper;
}

}  // namespace echolucent
