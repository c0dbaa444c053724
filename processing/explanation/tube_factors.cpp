#include "processing/explanation/tube_factors.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <variant>

#include "processing/adaptive/adapted_curve.h"
#include "processing/adaptive/quiet_reading.h"
#include "processing/tube_core/basis_factor.h"
#include "processing/tube_core/ramp.h"

namespace echolucent {

namespace {

std::vector<double> valuesOf(const ProductRule& /*rule*/, const TubeCore& tube) {
    std::vector<double> intensities(AdaptiveOtf::sampleCount), sums(intensities.size(), 0.0), lost = sums;
    for (std::size_t i = 0; i < intensities.size(); ++i) intensities[i] = AdaptiveOtf::intensityOf(i);
    const BasisFactor factor(*tube.lowIntensity, *tube.highIntensity, std::log1p(tube.d));
    addFactors({&factor, 1}, intensities, sums, lost);
    for (std::size_t i = 0; i < sums.size(); ++i) sums[i] = std::exp(sums[i] + lost[i]);
    return sums;
}

std::vector<double> valuesOf(const RampRule& rule, const TubeCore& tube) {
    std::vector<double> values(AdaptiveOtf::sampleCount);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = rampAt(AdaptiveOtf::intensityOf(i), tube, rule);
    return values;
}

}  // namespace

TubeCore curveTubeOf(const AdaptiveOtf& otf, std::size_t number) {
    const TubeCore& found = otf.tubes[number];
    TubeCore tube;
    tube.status = found.status;
    tube.d = found.d;
    tube.lowIntensity = otf.quiet.empty() ? found.lowIntensity : otf.quiet[number].low;
    tube.highIntensity = otf.quiet.empty() ? found.highIntensity : otf.quiet[number].high;
    tube.fluidSpread = otf.quiet.empty() ? found.fluidSpread : otf.quiet[number].fluidSpread;
    return tube;
}

CurveRule curveRuleOf(const AdaptiveOtf& otf) { return quieterRule(otf.config.curve, otf.speckleLeft.value_or(1.0)); }

TubeFactor factorOf(const TubeCore& curveTube, int number, const CurveRule& rule) {
    return {number, curveTube.d, std::visit([&](const auto& one) { return valuesOf(one, curveTube); }, rule)};
}

std::vector<int> heaviestFirst(const AdaptiveOtf& otf) {
    std::vector<int> numbers;
    if (otf.surfacesWhereDataBegin) return numbers;
    for (std::size_t t = 0; t < otf.tubes.size(); ++t)
        if (otf.tubes[t].d > 0.0) numbers.push_back(static_cast<int>(t));
    std::ranges::stable_sort(numbers, std::ranges::greater(),
                             [&](int number) { return otf.tubes[static_cast<std::size_t>(number)].d; });
    return numbers;
}

std::vector<TubeFactor> allFactors(const AdaptiveOtf& otf, std::size_t most) {
    const CurveRule rule = curveRuleOf(otf);
    const std::vector<int> order = heaviestFirst(otf);
    std::vector<TubeFactor> factors;
    for (const int number : std::span(order).first(std::min(most, order.size())))
        factors.push_back(factorOf(curveTubeOf(otf, static_cast<std::size_t>(number)), number, rule));
    return factors;
}

SampledCurve grownCurve(const AdaptiveOtf& otf, std::size_t count) {
    const std::vector<int> order = heaviestFirst(otf);
    std::vector<TubeCore> tubes;
    tubes.reserve(otf.tubes.size());
    for (std::size_t t = 0; t < otf.tubes.size(); ++t) tubes.push_back(curveTubeOf(otf, t));
    for (std::size_t place = 0; place < otf.tubes.size(); ++place)
        if (place >= count && place < order.size()) tubes[static_cast<std::size_t>(order[place])].d = 0.0;
    if (otf.surfacesWhereDataBegin) tubes.clear();
    return adaptedCurve(curveRuleOf(otf), otf.config.initial, tubes, AdaptiveOtf::sampleCount, otf.everyWall).curve;
}

}  // namespace echolucent
