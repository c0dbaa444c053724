#include <fmt/format.h>

#include <algorithm>

#include "app/measuring/otf/study_otf.h"

namespace echolucent::cli {

namespace {

double errorOf(const VariantResult& result, bool ofDetection) {
    return ofDetection ? 100.0 * (1.0 - result.detection.rightShare()) : result.rmsDifference();
}

/// A series called `name` with a marker for each result: error against run time.
PlotSeries seriesOf(const std::vector<const VariantResult*>& results, const std::string& name, bool ofDetection) {
    PlotSeries series;
    series.name = name;
    series.line = false;
    series.markers = true;
    for (const VariantResult* result : results) {
        series.x.push_back(result->timeRatio());
        series.y.push_back(errorOf(*result, ofDetection));
        series.labels.push_back(result->variant.value.empty() ? result->variant.name() : result->variant.value);
    }
    return series;
}

Plot curvesPlot(const OtfStudy& study) {
    Plot plot{"Opacity curves", "normalised intensity", "opacity per unit", false, false, {}};
    const auto add = [&](const std::string& name, const std::vector<double>& opacities) {
        plot.series.push_back(curveSeries(name, opacities));
    };
    const std::size_t count = std::min(study.readings.size(), allReadings.size());
    for (std::size_t i = count; i-- > 0;)
        add((i + 1 == count ? "adaptive, " : "") + std::string(nameOf(study.readings[i].reading)),
            study.readings[i].curve.opacities);
    add("parabolic, x²", sampledOpacities(parabolaCurve(), AdaptiveOtf::sampleCount));
    add("linear, eq. 1 with L_L = 20/255, a = 0.5", sampledOpacities(linearCurve(), AdaptiveOtf::sampleCount));
    return plot;
}

void addReadings(const OtfStudy& study, HtmlPage& page) {
    page.heading("The readings of the method");
    page.paragraph(
        "Published is the paper taken literally, with the erratum of eq. 5. Settled has its open points settled by "
        "experiment (docs/experiments.md). Default is what the program uses where nobody asks for another.");
    if (!study.truthKnown) {
        addTable(
            page, volumeTable(study),
            "Light from the surfaces is, for the rays along the tube cores' axes, the share of the composited "
            "intensity that comes from within 3 units of the surface found. It is given for the reading's own curve "
            "and for the curves that no tube core shapes.");
        for (const ReadingResult& result : study.readings)
            if (!result.message.empty()) page.paragraph(fmt::format("{}: {}", nameOf(result.reading), result.message));
        page.plot(curvesPlot(study));
        return;
    }
    addTable(page, detectionTable(study),
             "Right is the share of the weight Σd on tube cores whose surface is within 3 units of the first "
             "interface from fluid; on none is the share on tube cores without such an interface. Found is the "
             "share of the tube cores with an interface that found it. A volume without fluid should have no Σd.");
    addTable(page, contrastTable(study),
             "CNR_S compares the light from 2 units before to 6 behind the true surface of objects with all other "
             "light, over the root of the sum of both variances. Rays are parallel along the beam, with step 1 and "
             "without shading.");
    page.plot(curvesPlot(study));
}

}  // namespace

Plot paretoPlot(const OtfStudy& study, const std::string& function, bool ofDetection) {
    Plot plot;
    plot.title = fmt::format("{} by {}", ofDetection ? "Detection" : "Curve", function);
    plot.xLabel = "run time, as a ratio to the default setting";
    plot.yLabel = ofDetection ? "weight not on right tube cores, %" : "RMS difference of opacity from the reference";
    plot.logX = true;
    plot.logY = !ofDetection;
    std::vector<const VariantResult*> own;
    std::vector<std::pair<double, double>> front;
    for (const VariantResult& result : study.variants) {
        if (result.variant.interfaceFunction != function) continue;
        own.push_back(&result);
        if (!result.variant.isReference) front.emplace_back(result.timeRatio(), errorOf(result, ofDetection));
    }
    plot.series.push_back(frontSeries(std::move(front)));
    for (const std::string& parameter : namesIn(own, [](const auto* result) { return result->variant.parameter; })) {
        // The reference's error is 0 by definition, and a logarithmic axis has no 0.
        if (parameter == "reference" && !ofDetection) continue;
        std::vector<const VariantResult*> some;
        for (const VariantResult* result : own)
            if (result->variant.parameter == parameter) some.push_back(result);
        plot.series.push_back(seriesOf(some, parameter, ofDetection));
    }
    return plot;
}

std::string summaryText(const OtfStudy& study) {
    std::string text = study.subject + "\n\n" + plainText(variantTable(study)) + "\n";
    if (!study.truthKnown) return text + plainText(volumeTable(study));
    return text + plainText(detectionTable(study)) + "\nCNR_S\n" + plainText(contrastTable(study));
}

std::string otfPage(const OtfStudy& study) {
    HtmlPage page("The adaptive opacity transfer function: error against run time");
    page.paragraph(study.subject);
    page.paragraph(fmt::format(
        "Each setting is the default but for one parameter. Run time is the median of {} runs, in which the settings "
        "take turns, as a ratio to the default setting's on the same volume and view; the mean of these ratios over "
        "the volumes is geometric. The error of the curve is the difference of opacity, over all intensities, from "
        "the densest reference of the same interface indicating function (tube cores every 4 units, double "
        "precision). The reference itself has no error by "
        "definition; like every error of 0 it is not on a logarithmic axis.",
        study.repeats));
    page.heading("Error against run time");
    for (const bool ofDetection : {false, true}) {
        if (ofDetection && !study.truthKnown) continue;
        for (const std::string& function : interfaceFunctions) page.plot(paretoPlot(study, function, ofDetection));
    }
    addTable(page, variantTable(study),
             "● marks the front of the curve's error: nothing else is both faster and nearer to the reference.");
    addReadings(study, page);
    return page.text();
}

}  // namespace echolucent::cli
