#include "processing/theory/theory_plots.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace echolucent {

namespace {

enum class CourseValue { intoTissue, throughFluid, contrast };

double valueOf(const CurveContrast& one, CourseValue value) {
    switch (value) {
        case CourseValue::intoTissue: return one.pixels.tissue;
        case CourseValue::throughFluid: return one.pixels.fluid;
        case CourseValue::contrast: break;
    }
    return one.contrast.value_or(std::nan(""));
}

PlotSeries seriesOf(const ContrastCourse& course, std::size_t curve, CourseValue value) {
    PlotSeries series;
    series.name = course.contrasts.front()[curve].name;
    series.x = course.places;
    for (const auto& at : course.contrasts) series.y.push_back(valueOf(at[curve], value));
    return series;
}

Plot coursePlot(const TheorySetting& setting, CourseAxis axis) {
    Plot plot;
    plot.xLabel = labelOf(axis);
    if (const auto place = placeOf(setting.model, axis)) plot.marksX.push_back({*place, {}});
    return plot;
}

/// "a", "a and b", "a, b and c".
std::string listedNames(const std::vector<CurveContrast>& contrasts, const std::vector<std::size_t>& which) {
    std::string names;
    for (std::size_t i = 0; i < which.size(); ++i)
        names += (i == 0 ? "" : i + 1 < which.size() ? ", " : " and ") + contrasts[which[i]].name;
    return names;
}

std::string parabolaSentence(const TheorySetting& setting) {
    const std::vector<TheoryCurve> curves = curvesOf(setting);
    const auto units = unitsToBeat(setting.model, curves[1].curve, curves[0].curve);
    if (!units) return {};
    if (*units == 0.0) return " The parabola beats the line at every depth.";
    return " The parabola beats the line from " + std::to_string(static_cast<std::int64_t>(std::ceil(*units))) +
           " units of fluid on.";
}

}  // namespace

std::string labelOf(ContrastKind kind) {
    switch (kind) {
        case ContrastKind::difference: return "Difference, share of white";
        case ContrastKind::michelson: return "Michelson contrast";
        case ContrastKind::weber: break;
    }
    return "Weber contrast";
}

std::string labelOf(CourseAxis axis) { return axis == CourseAxis::depth ? "thickness of the fluid, units" : "c2 / c1"; }

std::optional<double> placeOf(const TwoIntensities& model, CourseAxis axis) {
    if (axis == CourseAxis::depth) return static_cast<double>(model.fluidUnits);
    if (!(model.tissue > 0.0) || model.fluid > model.tissue) return std::nullopt;
    return model.fluid / model.tissue;
}

Plot opacityPlot(const TheorySetting& setting) {
    constexpr int samples = 256;
    Plot plot{.title = "The curves", .xLabel = "intensity", .yLabel = "opacity per unit"};
    for (const TheoryCurve& named : curvesOf(setting)) {
        PlotSeries series;
        series.name = named.name;
        series.y = sampledOpacities(named.curve, samples);
        for (int i = 0; i < samples; ++i) series.x.push_back(static_cast<double>(i) / (samples - 1));
        plot.series.push_back(std::move(series));
    }
    plot.marksX = {{setting.model.fluid, "c2"}, {setting.model.tissue, "c1"}};
    return plot;
}

Plot pixelPlot(const TheorySetting& setting, const ContrastCourse& course, CourseAxis axis) {
    Plot plot = coursePlot(setting, axis);
    plot.title = "Pixels";
    plot.yLabel = "C(r), share of white";
    const std::size_t curves = course.contrasts.front().size();
    for (std::size_t i = 0; i < curves; ++i) plot.series.push_back(seriesOf(course, i, CourseValue::intoTissue));
    for (std::size_t i = 0; i < curves; ++i) {
        PlotSeries faint = seriesOf(course, i, CourseValue::throughFluid);
        faint.name = i == 0 ? "fluid alone" : "";  // the legend names them once
        faint.weight = PlotWeight::faint;
        plot.series.push_back(std::move(faint));
    }
    return plot;
}

Plot contrastPlot(const TheorySetting& setting, const ContrastCourse& course, CourseAxis axis) {
    Plot plot = coursePlot(setting, axis);
    plot.title = "Contrast";
    plot.yLabel = labelOf(setting.contrast);
    plot.logY = setting.contrast == ContrastKind::weber;
    for (std::size_t i = 0; i < course.contrasts.front().size(); ++i)
        plot.series.push_back(seriesOf(course, i, CourseValue::contrast));
    return plot;
}

std::string winnerSentence(const TheorySetting& setting) {
    const std::vector<CurveContrast> contrasts = contrastsOf(setting);
    const std::vector<std::size_t> winners = winnersOf(contrasts);
    if (winners.empty()) return "No curve shows the tissue." + parabolaSentence(setting);
    double most = 0.0;
    for (const std::size_t winner : winners)
        most = std::max(most, contrasts[winner].pixels.tissue - contrasts[winner].pixels.fluid);
    return "By difference, the tissue is shown best by " + listedNames(contrasts, winners) + ": " + shareText(most) +
           " of white." + parabolaSentence(setting);
}

std::string shareText(const std::optional<double>& value) {
    if (!value) return "-";
    // A value that rounds to 0 has no sign.
    const double shown = std::abs(*value) < 0.0005 ? 0.0 : *value;
    std::array<char, 400> text{};
    std::snprintf(text.data(), text.size(), "%.3f", shown);
    return text.data();
}

}  // namespace echolucent
