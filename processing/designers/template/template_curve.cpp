#include "processing/designers/template/template_curve.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "processing/designers/designer_contract.h"
#include "processing/designers/template/intensity_warp.h"
#include "processing/designers/template/template_reference.h"
#include "processing/parameters/parameter_rows.h"

namespace echolucent {

namespace {

constexpr std::string_view templatePage = "docs/designers/template.md";
constexpr int curveNodes = 256;

/// Whether a reference from elsewhere holds a histogram.
bool isHistogram(const std::vector<double>& histogram) {
    const double sum = std::accumulate(histogram.begin(), histogram.end(), 0.0);
    const bool areShares = std::ranges::all_of(histogram, [](double share) { return share >= 0.0; });
    return histogram.size() == warpBins && areShares && (sum == 0.0 || std::abs(sum - 1.0) < 1e-6);
}

/// The reference has no row, so it is checked here.
std::string problemOfReference(const TemplateConfig& config) {
    if (isHistogram(config.reference->histogram)) return {};
    return "the histogram of the reference must be 256 shares, 0 or more, with a sum of 1, or 0";
}

constexpr auto templateComparisons = parameter_rows::choicesOf<TemplateComparison>(templateComparisonNames);

const ParameterTable<TemplateConfig>& templateTable() {
    using namespace parameter_rows;
    using Config = TemplateConfig;
    static const ParameterTable<Config> table{
        {
            choice<templateComparisons, &Config::comparison>({"comparison", "Comparison",
                                                              "What the intensities of the volume and of the template "
                                                              "are compared by: the logarithms of their shares, "
                                                              "which asks little how much of a tissue there is, or the "
                                                              "cumulative distributions, which find a change of "
                                                              "gain alone more exactly",
                                                              "", templatePage}),
            number<&Config::leastSlope>(
                {"least_slope", "Least slope", "How much the intensity axis of the template may be pressed together",
                 "times", "Rezk-Salama and others 2000"},
                {1.0 / 8.0, 1}),
            number<&Config::largestSlope>(
                {"largest_slope", "Largest slope", "How much the intensity axis of the template may be stretched",
                 "times", "Rezk-Salama and others 2000"},
                {1, 8}),
        },
        {},
        problemOfReference};
    return table;
}

/// Why a histogram cannot be compared; empty if it can.
std::string whyNotCompared(const std::vector<double>& histogram, const std::string& what) {
    const auto filled = std::ranges::count_if(histogram, [](double share) { return share > 0.0; });
    if (filled == 0) return what + " holds no data";
    return filled == 1 ? "All data of " + what + " has one intensity" : std::string();
}

std::string beginningASentence(std::string words) {
    if (!words.empty() && words[0] == 't') words[0] = 'T';
    return words;
}

/// Intensities at the middle of the bins, and the shares there.
DesignPlot plotOf(std::string name, std::string label, const std::vector<double>& histogram) {
    DesignPlot plot{std::move(name), std::move(label), "share", {}, histogram};
    for (std::size_t bin = 0; bin < warpBins; ++bin)
        plot.intensities.push_back((static_cast<double>(bin) + 0.5) / static_cast<double>(warpBins));
    return plot;
}

DesignPlot plotOf(const IntensityWarp& warp) {
    DesignPlot plot{"warp", "Warp t(v)", "", {}, {}};
    for (int i = 0; i < curveNodes; ++i) {
        const double v = static_cast<double>(i) / (curveNodes - 1), t = warp.at(v);
        plot.intensities.push_back(v);
        plot.values.push_back(t >= 0.0 && t <= 1.0 ? t : std::numeric_limits<double>::quiet_NaN());
    }
    return plot;
}

struct Shift {
    double from = 0.0, by = 0.0;
};
Shift largestShift(const IntensityWarp& warp) {
    Shift largest;
    for (int i = 0; i < curveNodes; ++i) {
        const double v = static_cast<double>(i) / (curveNodes - 1), t = warp.at(v);
        if (t >= 0.0 && t <= 1.0 && std::abs(t - v) > std::abs(largest.by)) largest = {v, t - v};
    }
    return largest;
}

bool isClear(const OpacityCurve& curve) {
    return std::ranges::all_of(sampledOpacities(curve, curveNodes), [](double opacity) { return opacity == 0.0; });
}

SampledCurve carried(const OpacityCurve& curve, const IntensityWarp& warp) {
    SampledCurve carried;
    for (int i = 0; i < curveNodes; ++i)
        carried.opacities.push_back(opacityAt(curve, warp.inverse(static_cast<double>(i) / (curveNodes - 1))));
    return carried;
}

void describe(const FoundWarp& found, const std::string& name, Design& design) {
    const std::vector<double>& values = found.warp.values;
    const Shift shift = largestShift(found.warp);
    const double slope = values.back() - values.front();
    design.facts = {{"largest_shift", "Largest shift", shift.by, ""},
                    {"mean_slope", "Mean slope", slope, ""},
                    {"distance_before", "Distance before", found.distanceBefore, ""},
                    {"distance", "Distance", found.distance, ""}};
    design.explanation = {"The curve of the template \"" + name + "\" was carried over: what is " +
                              roundedInWords(shift.from, 0.001) + " there is " +
                              roundedInWords(shift.from + shift.by, 0.001) + " here, which is the largest shift.",
                          "The distributions of intensities were " + roundedInWords(found.distanceBefore, 0.001) +
                              " apart before and are " + roundedInWords(found.distance, 0.001) +
                              " apart now; the warp has a mean slope of " + roundedInWords(slope, 0.001) + "."};
}

}  // namespace

const ParameterTable<TemplateConfig>& parametersOf(const TemplateConfig&) { return templateTable(); }

std::optional<Design> design(const TemplateConfig& config, const DesignerInput& input, const Progress& progress) {
    requireDesignable("TemplateConfig", parametersOf(config), config, input);
    const TemplateReference& reference = *config.reference;
    if (progress.cancelled()) return std::nullopt;
    const std::vector<double> shown = templateFrom(input.shown, {}, {}).histogram;
    Design design{reference.curve};
    design.plots = {plotOf("reference_histogram", "Intensities of the template", reference.histogram),
                    plotOf("histogram", "Intensities", shown)};
    std::string why = whyNotCompared(shown, "the volume");
    if (why.empty()) why = whyNotCompared(reference.histogram, "the template");
    if (isClear(reference.curve)) {
        design.classification = PowerCurve{2, 1.0};
        design.message = "The template's curve shows nothing: the square of the intensity is used.";
        return design;
    }
    if (!why.empty()) {
        design.message = beginningASentence(why) + ": the curve of the template is used as it is.";
        return design;
    }
    const auto found =
        findWarp(reference.histogram, shown, {config.comparison, config.leastSlope, config.largestSlope}, progress);
    if (!found) return std::nullopt;
    design.classification = carried(reference.curve, found->warp);
    design.plots.insert(design.plots.begin(), plotOf(found->warp));
    describe(*found, reference.name, design);
    return design;
}

}  // namespace echolucent
