#include <fmt/format.h>

#include <algorithm>

#include "app/measuring/render/study_render.h"
#include "processing/ray_caster/ray_caster.h"

namespace echolucent::cli {

namespace {

constexpr int overviewEdge = 128, detailEdge = 80, zoom = 2;  // pixels; so the page keeps within HtmlPage::mostBytes
constexpr double amplification = 8.0;

/// The kernel's settings of one axis: RMSE against run time.
PlotSeries seriesOf(const std::vector<RenderResult>& results, const std::string& axis) {
    PlotSeries series;
    series.name = axis;
    series.line = false;
    series.markers = true;
    for (const RenderResult& result : results) {
        if (result.variant.plain || result.variant.axis != axis) continue;
        series.x.push_back(result.timeRatio);
        series.y.push_back(result.error.rmse);
        series.labels.push_back(result.letter);
        series.names.push_back(result.letter + ", " + result.variant.name());
    }
    return series;
}

/// RMSE over the step.
Plot stepPlot(const RenderStudy& study) {
    Plot plot{"Error over the step", "step, units", "RMSE, 8-bit levels", true, true, {}};
    std::vector<std::pair<double, double>> along;
    for (const RenderResult& result : study.results)
        if (result.variant.axis == "step" || result.variant.axis == "reference")
            along.emplace_back(result.variant.settings.step, result.error.rmse);
    std::ranges::sort(along);
    PlotSeries series{.name = "one sample a step", .x = {}, .y = {}, .markers = true, .labels = {}};
    for (const auto& [step, error] : along) {
        series.x.push_back(step);
        series.y.push_back(error);
    }
    plot.series.push_back(std::move(series));
    return plot;
}

/// The reference setting, the fastest one within each bound, and the settings of older hardware.
std::vector<std::pair<std::string, const RenderResult*>> shownResults(const RenderStudy& study) {
    std::vector<std::pair<std::string, const RenderResult*>> shown{{"reference setting", &study.results.front()}};
    const auto add = [&](const std::string& name, const RenderResult* result) {
        if (result == nullptr) return;
        const auto known =
            std::find_if(shown.begin(), shown.end(), [&](const auto& one) { return one.second == result; });
        if (known == shown.end())
            shown.emplace_back(name, result);
        else
            known->first += ", " + name;
    };
    for (const QualityBound& bound : qualityBounds())
        add(fmt::format("{} (RMSE {:g})", bound.name, bound.rmse), fastestWithin(bound, study.results));
    for (const RenderResult& result : study.results) {
        if (result.variant.axis == "interpolation") add("nearest voxel", &result);
        if (result.variant.plain == asTheKernel(1.0, CompositingPrecision::eightBit) &&
            result.variant.settings.step == 1.0)
            add("bytes", &result);
    }
    return shown;
}

void addPictures(HtmlPage& page, const RenderStudy& study, const RenderCase& one) {
    page.heading("Pictures");
    page.paragraph(fmt::format(
        "These are the luminances of the converged reference and of the middle {0} pixels an edge of each setting, "
        "{3} times enlarged. Beside each setting stands its difference from the reference, {1:g} times amplified: it "
        "is grey where there is none and brighter where the setting's picture is (black and white are {2:.0f} levels "
        "off).",
        detailEdge, amplification, 127.5 / amplification, zoom));
    page.picture(inGrey(overviewOf(study.converged, overviewEdge)), "The converged reference, reduced", zoom);
    const Picture detail = middleOf(study.converged, detailEdge, detailEdge);
    page.picture(inGrey(detail), "Its middle", zoom);
    RayCaster caster(one.volume);
    const Picture reference = pictureOf(study.results.front().variant, one, caster);
    page.picture(inGrey(overviewOf(signedDifference(reference, study.converged, amplification), overviewEdge)),
                 "The reference setting's difference over the whole picture, reduced", zoom);
    for (const auto& [name, result] : shownResults(study)) {
        const Picture middle = middleOf(pictureOf(result->variant, one, caster), detailEdge, detailEdge);
        page.picture(inGrey(middle), fmt::format("{}. {}: {}", result->letter, name, result->variant.name()), zoom);
        page.picture(inGrey(signedDifference(middle, detail, amplification)),
                     fmt::format("{}. Difference. RMSE {:.3g}, maximum {:.3g}, SSIM {:.5f}", result->letter,
                                 result->error.rmse, result->error.largest, result->error.ssim),
                     zoom);
    }
}

void addMethod(HtmlPage& page, const RenderStudy& study) {
    page.paragraph(study.subject);
    page.paragraph(fmt::format(
        "Errors are those of red, green and blue over black, in 8-bit levels, computed from the floats before they are "
        "rounded. The reference is a converged picture by the plain route (step 0.1 unit, trilinear, double, no ray "
        "ends early; it took {:.0f} s). The tables hold the RMSE over pixels and colours, the largest difference, and "
        "the mean SSIM of luminance (Wang et al. 2004, with a Gaussian window of 11 x 11 and sigma 1.5).",
        study.referenceSeconds));
    page.paragraph(fmt::format(
        "Run time is the wall time of a picture with {} thread(s): the median of {} runs, in which all settings take "
        "turns, each after a run that is not timed. Ratios are to the reference setting (step 1 unit, trilinear, "
        "float, rays end at 1/512, whole size). Between runs the camera turns by 0.01 degree or more, so that no "
        "samples of an unchanged view "
        "are "
        "reused; errors are those at the reference camera. Smaller pictures are enlarged bilinearly as the screen does "
        "it: a texture stretched over the whole picture, its pixel centres at halves, clamped at the edges; the time "
        "is "
        "that of the casting.",
        study.threads, study.repeats));
    page.paragraph(sameRaysText(study));
}

}  // namespace

Plot frontPlot(const RenderStudy& study) {
    Plot plot{"Error against run time",
              "run time, as a ratio to the reference setting",
              "RMSE, 8-bit levels",
              true,
              true,
              {}};
    std::vector<std::pair<double, double>> front;
    std::vector<std::string> axes;
    for (const RenderResult& result : study.results)
        if (!result.variant.plain) {
            if (result.onFront) front.emplace_back(result.timeRatio, result.error.rmse);
            if (std::ranges::find(axes, result.variant.axis) == axes.end()) axes.push_back(result.variant.axis);
        }
    plot.series.push_back(frontSeries(std::move(front)));
    for (const std::string& axis : axes) plot.series.push_back(seriesOf(study.results, axis));
    return plot;
}

std::string renderPage(const RenderStudy& study, const RenderCase& one) {
    HtmlPage page("The ray caster: error against run time");
    addMethod(page, study);
    page.heading("Error against run time");
    page.plot(frontPlot(study));
    page.plot(stepPlot(study));
    addTable(page, boundsTable(study),
             "The fastest setting of the kernel within each bound; frames/s are those of the casting alone.");
    addPictures(page, study, one);
    page.heading("All settings");
    addTable(page, settingsTable(study),
             "● marks the front: no other setting of the kernel is both faster and nearer to the reference. A "
             "combination ends its rays at a transmittance of 1/128.");
    page.heading("Compositing precision, and whole steps only");
    addTable(
        page, precisionTable(study),
        fmt::format(
            "How colour and transmittance are stored after every sample, by the plain route; all between "
            "is double. Its run times (the median of {} runs, as a ratio to double at step 1) compare "
            "among themselves only, not with the kernel's. Steps are cut where the volume's box begins and ends "
            "and count with the length that is left; \"whole steps only\" tells what it would cost not to do that.",
            study.plainRepeats));
    return page.text();
}

}  // namespace echolucent::cli
