#include "processing/document/curve_adjustment.h"

#include <algorithm>
#include <cmath>

#include "processing/parameters/parameter_rows.h"

namespace echolucent {

namespace {

constexpr int tableIntensities = 2041;               // the nodes of the ray caster's table
constexpr double leastRise = 0.02, mostRise = 0.98;  // keep both sides of the rise from vanishing

/// The intensity at which the curve first reaches half of its largest opacity.
double riseOf(const std::vector<double>& opacities) {
    const double half = 0.5 * *std::ranges::max_element(opacities);
    const auto at = std::ranges::find_if(opacities, [half](double opacity) { return opacity >= half; });
    return static_cast<double>(at - opacities.begin()) / static_cast<double>(opacities.size() - 1);
}

/// Finds the intensity whose opacity an adjusted curve shows at an intensity. `opacities` are those of the curve before
/// the adjustment.
class StretchedIntensities {
public:
    StretchedIntensities(const std::vector<double>& opacities, double threshold)
        : m_threshold(threshold),
          m_rise(std::clamp(riseOf(opacities), leastRise, mostRise)),
          m_moved(std::clamp(m_rise + threshold, leastRise, mostRise)) {}
    [[nodiscard]] double before(double intensity) const {
        if (m_threshold == 0.0) return intensity;
        return intensity <= m_moved ? intensity * m_rise / m_moved
                                    : 1.0 - (1.0 - intensity) * (1.0 - m_rise) / (1.0 - m_moved);
    }

private:
    double m_threshold, m_rise, m_moved;
};

bool isClear(const std::vector<double>& opacities) {
    return std::ranges::all_of(opacities, [](double opacity) { return opacity == 0.0; });
}

double depthFactorOf(const CurveAdjustment& adjustment) { return std::pow(4.0, -adjustment.transparency); }

}  // namespace

const ParameterTable<CurveAdjustment>& adjustmentParameters() {
    using namespace parameter_rows;
    static const ParameterTable<CurveAdjustment> table{
        {number<&CurveAdjustment::threshold>(
             {"threshold", "Threshold", "To the right only brighter echoes show", "", "chosen by looking"},
             {-0.5, 0.5}),
         number<&CurveAdjustment::transparency>(
             {"transparency", "Transparency", "To the right you see deeper; black fluid stays clear either way", "",
              "chosen by looking"},
             {-1, 1}, {.steps = ParameterSteps{0.01, 2}})}};
    return table;
}

OpacityCurve adjusted(const OpacityCurve& curve, const CurveAdjustment& adjustment) {
    if (adjustment == CurveAdjustment{}) return curve;
    SampledCurve sampled{sampledOpacities(curve, tableIntensities)};
    if (isClear(sampled.opacities)) return curve;
    const StretchedIntensities stretched(sampled.opacities, adjustment.threshold);
    const double depth = depthFactorOf(adjustment);
    for (int i = 0; i < tableIntensities; ++i) {
        const double before = stretched.before(static_cast<double>(i) / (tableIntensities - 1));
        sampled.opacities[static_cast<std::size_t>(i)] = opacityForStep(opacityAt(curve, before), depth);
    }
    return sampled;
}

Classification adjustedClassification(const Classification& classification, const CurveAdjustment& adjustment) {
    if (!classification.isTwoDimensional()) return adjusted(classification.curve(), adjustment);
    if (adjustment == CurveAdjustment{}) return classification;
    const std::vector<double> upper = sampledOpacities(upperCurveOf(classification), tableIntensities);
    if (isClear(upper)) return classification;
    const TwoDimensionalOtf& otf = *classification.twoDimensional();
    const StretchedIntensities stretched(upper, adjustment.threshold);
    const double depth = depthFactorOf(adjustment);
    return Classification(tabulated(otf.intensities, otf.gradients, otf.largestGradient, [&](double f, double g) {
        return opacityForStep(opacityAt(otf, stretched.before(f), g), depth);
    }));
}

}  // namespace echolucent
