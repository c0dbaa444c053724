#include <algorithm>
#include <cmath>

#include "app/measuring/theory/study_theory.h"
#include "processing/adaptive/adaptive_otf.h"

namespace echolucent::cli {

namespace {

std::vector<TheoryRow> rowsOf(const TheoryMeasure& measure, const TwoIntensityVolume& wanted, OpacityScaling scaling) {
    TheorySetting setting = measure.setting;
    setting.model = wanted.model;
    setting.scaling = scaling;
    const Volume volume = makeTwoIntensityVolume(wanted);
    std::vector<TheoryRow> rows;
    for (const TheoryCurve& named : curvesOf(setting)) {
        TheoryRow row{named.name,         scaling,
                      wanted.model,       wanted.speckle,
                      wanted.speckleSize, pixelsOf(wanted.model, named.curve),
                      std::nullopt,       measuredPixels(volume, named.curve, wanted.model.background)};
        if (wanted.speckle > 0.0) row.mean = speckledPixelsOf(wanted.model, named.curve, wanted.speckle);
        rows.push_back(std::move(row));
    }
    return rows;
}

double largestOf(const HalfField& half, double theory) {
    return std::max(std::abs(half.least - theory), std::abs(half.most - theory));
}

TwoIntensities withRatio(TwoIntensities model, double ratio) {
    model.fluid = ratio * model.tissue;
    return model;
}

CurveContrast contrastBy(const TwoIntensities& model, const OpacityCurve& curve) {
    const ModelPixels pixels = pixelsOf(model, curve);
    return {"adaptive", opacityAt(curve, model.fluid), opacityAt(curve, model.tissue), pixels,
            contrastOf(pixels, ContrastKind::difference)};
}

}  // namespace

double TheoryRow::largestError() const {
    return std::max(largestOf(picture.fluid, theory.fluid), largestOf(picture.tissue, theory.tissue));
}

std::optional<double> TheoryRow::toNoise() const {
    const double noise = std::hypot(picture.fluid.spread, picture.tissue.spread);
    return noise > 0.0 && speckle > 0.0 ? std::optional(difference() / noise) : std::nullopt;
}

namespace {

/// Ascending, each once, with that of the setting.
std::vector<double> withOwnRatio(std::vector<double> ratios, const TheorySetting& setting) {
    if (setting.model.tissue > 0.0) ratios.push_back(setting.model.fluid / setting.model.tissue);
    std::ranges::sort(ratios);
    ratios.erase(std::unique(ratios.begin(), ratios.end()), ratios.end());
    return ratios;
}

}  // namespace

std::vector<double> measuredRatios(const TheorySetting& setting) { return withOwnRatio({0.05, 0.3, 0.6}, setting); }

std::vector<TheoryRow> measurePlain(const TheoryMeasure& measure) {
    constexpr int narrow = 8;  // all rays of a half are the same
    std::vector<TheoryRow> rows;
    for (const OpacityScaling scaling : {OpacityScaling::sameScale, OpacityScaling::sameAtTissue})
        for (const std::int64_t units : measuredUnits)
            for (const double ratio : measuredRatios(measure.setting)) {
                TwoIntensities model = withRatio(measure.setting.model, ratio);
                model.fluidUnits = units;
                std::ranges::move(rowsOf(measure, {.model = model, .edge = narrow}, scaling), std::back_inserter(rows));
            }
    return rows;
}

std::vector<TheoryRow> measureSpeckled(const TheoryMeasure& measure) {
    std::vector<TheoryRow> rows;
    for (const double speckle : {0.5, 1.0})
        for (const double size : {0.0, 2.0}) {
            const TwoIntensityVolume wanted{measure.setting.model, measure.edge, speckle, size, measure.seed};
            std::ranges::move(rowsOf(measure, wanted, measure.setting.scaling), std::back_inserter(rows));
        }
    return rows;
}

std::vector<AdaptiveRow> measureAdaptive(const TheoryMeasure& measure) {
    constexpr double speckles[] = {0.0, 0.5, 1.0};
    // From 0.4 to 0.5 the method stops to find surfaces.
    const std::vector<double> ratios = withOwnRatio({0.05, 0.3, 0.4, 0.5, 0.6}, measure.setting);
    std::vector<AdaptiveRow> rows;
    for (const double ratio : ratios)
        for (const double speckle : speckles) {
            const TwoIntensities model = withRatio(measure.setting.model, ratio);
            const Volume volume =
                makeTwoIntensityVolume({model, std::max(measure.edge, 64), speckle, 2.0, measure.seed});
            const AdaptiveOtf otf = *adaptOpacity(volume, Viewpoint{}, AdaptiveOtfConfig{});
            const MeanInterface mean = meanInterfaceOf(otf);
            rows.push_back({model, speckle, otf.tubesMeetingVolume, otf.tubesWithWeight, mean.low, mean.high,
                            contrastBy(model, adaptiveCurveOf(model)), contrastBy(model, otf.curve)});
        }
    return rows;
}

std::vector<CrossingRow> measureCrossings(const TheorySetting& setting) {
    std::vector<CrossingRow> rows;
    for (const double tissue : {50.0, 85.0, 128.0, 170.0})
        for (const std::int64_t tissueUnits : {5, 10, 40})
            for (const double ratio : {0.1, 0.2, 0.4}) {
                TheorySetting at = setting;
                at.scaling = OpacityScaling::sameScale;
                at.model.tissue = tissue / 255.0;
                at.model.fluid = ratio * at.model.tissue;
                at.model.tissueUnits = tissueUnits;
                const std::vector<TheoryCurve> curves = curvesOf(at);
                rows.push_back(
                    {at.model.tissue, ratio, tissueUnits, unitsToBeat(at.model, curves[1].curve, curves[0].curve)});
            }
    return rows;
}

TheoryFindings measureTheory(const TheoryMeasure& measure) {
    return {measure, measurePlain(measure), measureSpeckled(measure), measureAdaptive(measure),
            measureCrossings(measure.setting)};
}

}  // namespace echolucent::cli
