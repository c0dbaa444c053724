#include "processing/explanation/explanation_plots.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "processing/parameters/parameter.h"
#include "processing/tube_core/tube_weights.h"

namespace echolucent {

namespace {

constexpr double gap = std::numeric_limits<double>::quiet_NaN();
constexpr const char* alongTheTube = "units along the tube core";
constexpr std::size_t cellsColour = 0, surfaceColour = 1;  // the same with and without quiet voxels

/// Where the middle of a cell lies, units from the first sample.
double middleOf(const TubeExplanation& explained, int cell) { return cell + (explained.config.cells.size - 1) / 2.0; }

PlotSeries samplesSeries(std::string name, const std::vector<double>& values) {
    PlotSeries series{.name = std::move(name), .x = {}, .y = values};
    for (std::size_t k = 0; k < values.size(); ++k) series.x.push_back(static_cast<double>(k));
    return series;
}

/// Values of the cells of a range; `values[0]` is that of cell `first`.
template <typename Values>
PlotSeries cellsSeries(std::string name, const TubeExplanation& explained, const Values& values, int first,
                       const IndexRange& range) {
    PlotSeries series{.name = std::move(name), .x = {}, .y = {}};
    for (int cell = range.first; cell <= range.last; ++cell) {
        series.x.push_back(middleOf(explained, cell));
        series.y.push_back(static_cast<double>(values[static_cast<std::size_t>(cell - first)]));
    }
    return series;
}

/// The stretch of the axis that cells cover.
PlotBand cellsBand(const TubeExplanation& explained, const IndexRange& cells, std::string label) {
    return {cells.first - 0.5, cells.last + explained.config.cells.size - 0.5, std::move(label)};
}

bool found(const TubeExplanation& explained) { return explained.tube.status == TubeStatus::surface; }

std::string titleOf(const TubeExplanation& explained, const std::string& what) {
    return what + " of tube core " + std::to_string(explained.number);
}

void markSurface(const TubeExplanation& explained, Plot& plot) {
    if (found(explained)) plot.marksX.push_back({middleOf(explained, explained.tube.surfaceCell), "surface"});
}

PlotSeries pointsSeries(std::string name) {
    PlotSeries points{.name = std::move(name), .x = {}, .y = {}, .line = false, .markers = true};
    points.weight = PlotWeight::heavy;
    return points;
}

void addScales(const TubeExplanation& explained, Plot& plot) {
    PlotSeries maxima = pointsSeries("maximum found"), ranges{.name = "range searched", .x = {}, .y = {}};
    double largest = 0.0;
    const IndexRange cells = explained.cells.tube;
    for (const TrackedScale& scale : explained.scales) {
        const std::string name = scale.sigma ? "σ = " + textOf(*scale.sigma) : "unsmoothed";
        plot.series.push_back(cellsSeries(name, explained, scale.function, cells.first, cells));
        if (!scale.sigma) plot.series.back().weight = PlotWeight::heavy;
        for (const double value : scale.function) largest = std::max(largest, value);
        if (!scale.cell) continue;
        maxima.x.push_back(middleOf(explained, *scale.cell));
        maxima.y.push_back(scale.function[static_cast<std::size_t>(*scale.cell - cells.first)]);
        maxima.names.push_back(name);
    }
    // Bars above the curves: the coarsest scale searches all of the tube core, each finer one a part of that.
    constexpr double step = 0.05;
    const auto scales = static_cast<double>(explained.scales.size());
    for (std::size_t i = 0; i < explained.scales.size(); ++i) {
        const IndexRange searched = explained.scales[i].searched;
        if (searched.empty()) continue;
        const double height = largest * (1.0 + step * (scales - static_cast<double>(i)));
        for (const double x : {middleOf(explained, searched.first), middleOf(explained, searched.last), gap}) {
            ranges.x.push_back(x);
            ranges.y.push_back(height);
        }
    }
    if (largest > 0.0) plot.rangeY = PlotRange{0.0, largest * (1.0 + step * (scales + 2.5))};
    plot.series.push_back(std::move(ranges));
    plot.series.push_back(std::move(maxima));
}

/// The counts of equal bins from the least to the largest value, as steps, relative to the fullest one.
PlotSeries histogramOf(const std::vector<double>& ascending) {
    constexpr std::size_t bins = 32;
    PlotSeries steps{.name = "histogram, of its fullest bin", .x = {}, .y = {}};
    steps.weight = PlotWeight::faint;
    if (ascending.empty()) return steps;
    const double least = ascending.front(), width = (ascending.back() - least) / bins;
    std::array<double, bins> counts{};
    for (const double value : ascending)
        counts[width > 0.0 ? std::min(static_cast<std::size_t>((value - least) / width), bins - 1) : 0] += 1.0;
    const double most = *std::max_element(counts.begin(), counts.end());
    for (std::size_t bin = 0; bin < bins; ++bin) {
        steps.x.insert(steps.x.end(),
                       {least + width * static_cast<double>(bin), least + width * static_cast<double>(bin + 1)});
        steps.y.insert(steps.y.end(), {counts[bin] / most, counts[bin] / most});
    }
    return steps;
}

Plot rankPlot(const TubeExplanation& explained, const WeightRank& rank, bool byIntensity) {
    const std::string weight = byIntensity ? "w_I" : "w_S", value = byIntensity ? "Î_L" : "S";
    Plot plot;
    plot.title = titleOf(explained, weight);
    plot.xLabel = byIntensity ? "Î_L, the largest prior mean" : "S, the slope at the surface, per unit";
    plot.yLabel = weight + "; tube cores, of the fullest bin";
    plot.rangeY = PlotRange{0.0, 1.0};
    plot.series.push_back(histogramOf(rank.values));
    const auto first =
        byIntensity ? rank.values.begin() : std::upper_bound(rank.values.begin(), rank.values.end(), 0.0);
    const std::vector<double> counted(first, rank.values.end());
    const std::vector<int> ranks = inclusiveRanks(counted, explained.config.weights.rankBins);
    PlotSeries weights{.name = byIntensity ? "w_I = 1 − rank / N" : "w_S = rank / N", .x = counted, .y = {}};
    for (const int one : ranks) {
        const double share = static_cast<double>(one) / std::max(1, rank.total);
        weights.y.push_back(byIntensity ? 1.0 - share : share);
    }
    plot.series.push_back(std::move(weights));
    if (!rank.value) return plot;
    PlotSeries own = pointsSeries("tube core " + std::to_string(explained.number));
    own.x = {*rank.value};
    own.y = {rank.weight};
    plot.series.push_back(std::move(own));
    plot.marksX.push_back({*rank.value, value});
    return plot;
}

std::vector<double> curveIntensities() {
    std::vector<double> intensities(AdaptiveOtf::sampleCount);
    for (std::size_t i = 0; i < intensities.size(); ++i) intensities[i] = AdaptiveOtf::intensityOf(i);
    return intensities;
}

PlotSeries curveSeries(std::string name, const std::vector<double>& values) {
    return {.name = std::move(name), .x = curveIntensities(), .y = values};
}

/// "225", or "the 100 heaviest of 225".
std::string countText(std::size_t count, std::size_t all) {
    const std::string few = std::to_string(count);
    return count == 0 || count >= all ? few : "the " + few + " heaviest of " + std::to_string(all);
}

/// "parabolic", so that the line has the colour of that curve; else "initial function".
std::string initialName(const OpacityCurve& initial) {
    const std::string name = "initial function";
    if (std::holds_alternative<LinearCurve>(initial)) return "linear " + name;
    const auto* power = std::get_if<PowerCurve>(&initial);
    if (power == nullptr) return name;
    return power->exponent == 2 ? "parabolic " + name : power->exponent == 4 ? "quartic " + name : name;
}

}  // namespace

Plot intensityProfilePlot(const TubeExplanation& explanation) {
    const TubeCore& tube = explanation.tube;
    Plot plot;
    plot.title = titleOf(explanation, "Intensities");
    plot.xLabel = alongTheTube;
    plot.yLabel = "intensity";
    plot.series.push_back(samplesSeries("voxels on the axis", explanation.axis.read));
    plot.series.back().weight = PlotWeight::faint;
    if (!explanation.axis.shown.empty())
        plot.series.push_back(samplesSeries("quiet voxels on the axis", explanation.axis.shown));
    plot.series.push_back(cellsSeries("means of cells", explanation, tube.cellMeans, 0, explanation.cells.tube));
    plot.series.back().weight = PlotWeight::heavy;
    plot.series.back().colour = cellsColour;
    if (explanation.fluidIntensity) plot.marksY.push_back({*explanation.fluidIntensity, "fluid level"});
    if (!found(explanation)) return plot;
    plot.bands.push_back(cellsBand(explanation, explanation.cells.low, "cells of I_L"));
    plot.bands.push_back(
        cellsBand(explanation, {explanation.cells.highCell, explanation.cells.highCell}, "cell of I_H"));
    PlotSeries surface = pointsSeries("surface");
    surface.colour = surfaceColour;
    surface.x = {middleOf(explanation, tube.surfaceCell)};
    surface.y = {static_cast<double>(tube.cellMeans[static_cast<std::size_t>(tube.surfaceCell)])};
    plot.series.push_back(std::move(surface));
    markSurface(explanation, plot);
    plot.marksY.push_back({*tube.lowIntensity, "I_L"});
    plot.marksY.push_back({*tube.highIntensity, "I_H"});
    return plot;
}

Plot interfaceFunctionPlot(const TubeExplanation& explanation) {
    Plot plot;
    plot.title = titleOf(explanation, "Interface function");
    plot.xLabel = alongTheTube;
    markSurface(explanation, plot);
    if (std::holds_alternative<VarianceRule>(explanation.config.detection)) {
        plot.yLabel = "variance of intensity in a cell";
        addScales(explanation, plot);
        return plot;
    }
    plot.yLabel = "contrast, standard deviations of a slab's voxels";
    plot.series.push_back(
        cellsSeries("contrast", explanation, explanation.tube.interfaceFunction, 0, explanation.contrastCells));
    plot.series.back().weight = PlotWeight::heavy;
    if (explanation.leastContrast) plot.marksY.push_back({*explanation.leastContrast, "least contrast"});
    return plot;
}

std::array<Plot, 2> rankPlots(const TubeExplanation& explanation) {
    return {rankPlot(explanation, explanation.intensityRank, true),
            rankPlot(explanation, explanation.slopeRank, false)};
}

Plot factorsPlot(const TubeExplanation& explanation, std::span<const TubeFactor> all) {
    const bool ramps = std::holds_alternative<RampRule>(explanation.config.curve);
    Plot plot;
    plot.title = titleOf(explanation, ramps ? "Ramp" : "Basis function");
    plot.xLabel = "intensity";
    plot.yLabel = ramps ? "ramp" : "factor f_t";
    plot.rangeX = PlotRange{0.0, 1.0};
    if (ramps) plot.rangeY = PlotRange{0.0, 1.0};
    PlotSeries others{.name = countText(all.size(), static_cast<std::size_t>(explanation.full.tubesWithWeight)) +
                              " tube cores with a weight",
                      .x = {},
                      .y = {}};
    others.weight = PlotWeight::faint;
    const std::vector<double> intensities = curveIntensities();
    for (const TubeFactor& factor : all) {
        others.x.insert(others.x.end(), intensities.begin(), intensities.end());
        others.y.insert(others.y.end(), factor.values.begin(), factor.values.end());
        others.x.push_back(gap);
        others.y.push_back(gap);
    }
    plot.series.push_back(std::move(others));
    if (!explanation.factor) return plot;
    plot.series.push_back(curveSeries("tube core " + std::to_string(explanation.number), explanation.factor->values));
    plot.series.back().weight = PlotWeight::heavy;
    const QuietInterface read = explanation.quiet.value_or(
        QuietInterface{explanation.tube.lowIntensity, explanation.tube.highIntensity, explanation.tube.fluidSpread});
    plot.marksX = {{*read.low, "I_L"}, {*read.high, "I_H"}};
    return plot;
}

Plot curvesPlot(const TubeExplanation& explanation) {
    Plot plot;
    plot.title = "The curve with and without tube core " + std::to_string(explanation.number);
    plot.xLabel = "intensity";
    plot.yLabel = "opacity per unit";
    plot.rangeX = PlotRange{0.0, 1.0};
    plot.rangeY = PlotRange{0.0, 1.0};
    plot.series.push_back(curveSeries(initialName(explanation.config.initial), explanation.initial));
    plot.series.push_back(curveSeries("adaptive curve", explanation.full.curve.opacities));
    plot.series.back().weight = PlotWeight::heavy;
    plot.series.push_back(curveSeries("without it", explanation.without.curve.opacities));
    plot.series.push_back(curveSeries("it alone", explanation.alone.curve.opacities));
    return plot;
}

Plot curveChangePlot(const TubeExplanation& explanation) {
    Plot plot;
    plot.title = "Change without tube core " + std::to_string(explanation.number);
    plot.xLabel = "intensity";
    plot.yLabel = "change of opacity per unit";
    plot.rangeX = PlotRange{0.0, 1.0};
    std::vector<double> change = explanation.without.curve.opacities;
    for (std::size_t i = 0; i < change.size(); ++i) change[i] -= explanation.full.curve.opacities[i];
    plot.series.push_back(curveSeries("without it, less the adaptive curve", change));
    return plot;
}

PlotSeries grownSeries(const SampledCurve& curve, std::size_t count, std::size_t all) {
    return curveSeries("of the " + std::to_string(count) + " heaviest of " + std::to_string(all), curve.opacities);
}

}  // namespace echolucent
