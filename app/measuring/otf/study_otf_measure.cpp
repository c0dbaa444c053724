#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <tuple>

#include "app/measuring/otf/study_otf.h"
#include "processing/adaptive/adaptive_otf.h"
#include "processing/adaptive/halved_lengths.h"
#include "processing/adaptive/method_reading.h"
#include "processing/median.h"

namespace echolucent::cli {

namespace {

/// The truth of the tube cores, computed once for each grid and cell size.
class TruthOfGrids {
public:
    explicit TruthOfGrids(const OtfCase& one) : m_case(one) {}
    const std::vector<TubeTruth>& of(const AdaptiveOtfConfig& config) {
        const auto key = std::tuple(config.grid.columns, config.grid.rows, config.grid.spacing, config.cells.size);
        const auto known = m_known.find(key);
        if (known != m_known.end()) return known->second;
        return m_known[key] = tubeTruths(*m_case.truth, m_case.volume->geometry(), m_case.view, config);
    }

private:
    const OtfCase& m_case;
    std::map<std::tuple<int, int, double, int>, std::vector<TubeTruth>> m_known;
};

/// Adds the differences between two curves with equally many samples.
void addDifference(const SampledCurve& curve, const SampledCurve& reference, VariantResult& result) {
    for (std::size_t i = 0; i < curve.opacities.size(); ++i) {
        const double difference = std::abs(curve.opacities[i] - reference.opacities[i]);
        result.largestDifference = std::max(result.largestDifference, difference);
        result.sumOfSquares += difference * difference;
    }
    result.samples += curve.opacities.size();
}

/// The median run time of each variant in ms, and last that of the default setting. Every round runs all of them once,
/// so that other load on the machine meets them alike.
std::vector<double> medianTimes(const OtfCase& one, const std::vector<OtfVariant>& variants, int repeats) {
    std::vector<std::vector<double>> times(variants.size() + 1);
    for (int round = 0; round < repeats; ++round)
        for (std::size_t v = 0; v <= variants.size(); ++v) {
            const AdaptiveOtfConfig config = v < variants.size() ? variants[v].config : AdaptiveOtfConfig{};
            times[v].push_back(adaptOpacity(*one.volume, one.view, config)->times.total);
        }
    std::vector<double> medians;
    medians.reserve(times.size());
    for (auto& own : times) medians.push_back(medianOf(std::move(own)));
    return medians;
}

}  // namespace

double VariantResult::rmsDifference() const {
    return samples > 0 ? std::sqrt(sumOfSquares / static_cast<double>(samples)) : 0.0;
}

double VariantResult::timeRatio() const {
    double sum = 0.0;
    for (const double ratio : timeRatios) sum += std::log(ratio);
    return timeRatios.empty() ? 0.0 : std::exp(sum / static_cast<double>(timeRatios.size()));
}

double VariantResult::time() const {
    if (times.empty()) return 0.0;
    return std::accumulate(times.begin(), times.end(), 0.0) / static_cast<double>(times.size());
}

void measureErrors(const OtfCase& one, std::vector<VariantResult>& results) {
    const auto variants = otfVariants(one.volume->geometry(), one.view);
    if (results.empty())
        for (const OtfVariant& variant : variants) {
            results.emplace_back();
            results.back().variant = variant;
        }
    TruthOfGrids truths(one);
    std::map<std::string, SampledCurve> references;
    for (const OtfVariant& variant : variants)
        if (variant.isReference)
            references[variant.interfaceFunction] = adaptOpacity(*one.volume, one.view, variant.config)->curve;
    for (std::size_t v = 0; v < variants.size(); ++v) {
        const AdaptiveOtf otf = *adaptOpacity(*one.volume, one.view, variants[v].config);
        addDifference(otf.curve, references[variants[v].interfaceFunction], results[v]);
        if (one.truth != nullptr)
            results[v].detection.add(detectionQuality(otf, truths.of(configUsed(otf)), one.volume->geometry()));
    }
}

void measureTimes(const OtfCase& one, int repeats, std::vector<VariantResult>& results) {
    const auto variants = otfVariants(one.volume->geometry(), one.view);
    const auto times = medianTimes(one, variants, repeats);
    for (std::size_t v = 0; v < variants.size(); ++v) {
        results[v].times.push_back(times[v]);
        // A coarse clock must not make the ratio infinite.
        constexpr double leastTime = 1e-6;
        results[v].timeRatios.push_back(std::max(times[v], leastTime) / std::max(times.back(), leastTime));
    }
}

void markFront(std::vector<VariantResult>& results) {
    for (VariantResult& result : results) {
        const auto beats = [&](const VariantResult& other) {
            return !other.variant.isReference && other.variant.interfaceFunction == result.variant.interfaceFunction &&
                   isBeaten(result.timeRatio(), result.rmsDifference(), other.timeRatio(), other.rmsDifference());
        };
        result.onFront = !result.variant.isReference && std::none_of(results.begin(), results.end(), beats);
    }
}

ReadingResult measureReading(const OtfCase& one, MethodReading reading) {
    const AdaptiveOtf otf = *adaptOpacity(*one.volume, one.view, configOf(reading));
    ReadingResult result;
    result.condition = one.name;
    result.view = one.view;
    result.reading = reading;
    for (const TubeCore& tube : otf.tubes) result.sumOfWeights += tube.d;
    result.tubesWithWeight = otf.tubesWithWeight;
    result.message = otf.message;
    result.curve = otf.curve;
    const std::vector<Classification> curves{otf.curve, parabolaCurve(), linearCurve()};
    const auto rays = tubeCoreRays(one.volume->geometry(), otf);
    const auto measures = *measuresOf(*one.volume, one.view, rays, curves);
    result.light = measures[0].light;
    result.parabolaLight = measures[1].light;
    result.linearLight = measures[2].light;
    if (one.truth != nullptr) result.detection = detectionQuality(otf, *one.truth, one.volume->geometry());
    return result;
}

}  // namespace echolucent::cli
