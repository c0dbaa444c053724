#include <fmt/format.h>

#include "app/measuring/light/study_light.h"
#include "app/measuring/study_output.h"

namespace echolucent::cli {

namespace {

std::string variantName(const LightVariant& variant) {
    return variant.value.empty() ? variant.parameter : variant.parameter + " " + variant.value;
}

Plot errorPlot(const LightStudy& study) {
    Plot plot{study.name + ": error against time",
              "milliseconds, a new camera and a new curve",
              "RMSE of the picture, 8-bit levels",
              true,
              true,
              {}};
    PlotSeries series{"light volumes", {}, {}, false, true, {}};
    for (const LightResult& result : study.results) {
        series.x.push_back(result.milliseconds);
        series.y.push_back(result.error.rmse);
        series.labels.push_back(variantName(result.variant));
    }
    plot.series.push_back(series);
    return plot;
}

std::vector<std::string> cellsOf(const LightResult& result) {
    return {variantName(result.variant),
            fmt::format("{:.2f}", result.error.rmse),
            fmt::format("{:.1f}", result.error.largest),
            fmt::format("{:.4f}", result.error.ssim),
            fmt::format("{:.1f}", result.milliseconds),
            fmt::format("{:.1f}", result.turnedMilliseconds),
            fmt::format("{:.1f}", result.keyMilliseconds)};
}

void addStudy(HtmlPage& page, const LightStudy& study) {
    page.heading(study.name);
    page.picture(study.reference, "The reference's light", 2);
    page.picture(study.usual, "The default light volume", 2);
    page.picture(signedDifference(study.usual, study.reference, 8.0), "Difference, eight times", 2);
    std::vector<std::vector<std::string>> rows;
    for (const LightResult& result : study.results) rows.push_back(cellsOf(result));
    page.table(
        {"light volume", "RMSE", "maximum", "SSIM", "ms", "ms, camera alone", "ms, key light alone"}, rows,
        fmt::format("The picture's error, and the time of the light volume. Without light that reaches, gradient "
                    "light alone, the RMSE is {:.1f}. The reference's picture took {:.0f} s.",
                    study.withoutReaching.rmse, study.referenceSeconds));
    page.plot(errorPlot(study));
}

}  // namespace

std::string lightCsv(const std::vector<LightStudy>& studies) {
    CsvTable table({"scene", "parameter", "value", "coarseness", "key_directions", "directions_around", "rmse",
                    "maximum", "ssim", "time_ms", "camera_time_ms", "key_time_ms"});
    for (const LightStudy& study : studies)
        for (const LightResult& result : study.results) {
            const LightScene& scene = result.variant.scene;
            table.row({study.name, result.variant.parameter, result.variant.value, scene.coarseness,
                       static_cast<int>(scene.keyDirections), static_cast<int>(scene.aroundDirections),
                       result.error.rmse, result.error.largest, result.error.ssim, result.milliseconds,
                       result.turnedMilliseconds, result.keyMilliseconds});
        }
    return table.text();
}

std::string lightSummary(const std::vector<LightStudy>& studies) {
    std::string text = fmt::format("{:<24}{:<24}{:>8}{:>9}{:>9}{:>10}{:>8}\n", "scene", "light volume", "RMSE",
                                   "maximum", "ms", "camera", "key");
    for (const LightStudy& study : studies)
        for (const LightResult& result : study.results)
            text += fmt::format("{:<24}{:<24}{:>8.2f}{:>9.1f}{:>9.1f}{:>10.1f}{:>8.1f}\n", study.name,
                                variantName(result.variant), result.error.rmse, result.error.largest,
                                result.milliseconds, result.turnedMilliseconds, result.keyMilliseconds);
    return text;
}

std::string lightPage(const std::vector<LightStudy>& studies, int repeats, int rings) {
    HtmlPage page("Light that reaches: error against time");
    page.paragraph(fmt::format(
        "Pictures by the plain route, in double, with light from a light volume, against the same pictures with light "
        "that every sample marches to: {} directions in the key light's cone and {} in the viewer's hemisphere, every "
        "half unit. Errors are those of red, green and blue over black, in 8-bit levels. Times are medians of {} runs, "
        "in which all light volumes take turns.",
        3 * rings * rings, 3 * rings * rings, repeats));
    for (const LightStudy& study : studies) addStudy(page, study);
    return page.text();
}

}  // namespace echolucent::cli
