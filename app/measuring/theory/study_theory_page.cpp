#include <fmt/format.h>

#include <algorithm>

#include "app/measuring/study_output.h"
#include "app/measuring/theory/study_theory.h"
#include "processing/theory/theory_plots.h"

namespace echolucent::cli {

namespace {

std::string percent(double share) { return fmt::format("{:.4f}", 100.0 * share); }
std::string level(double intensity) { return fmt::format("{:.0f}", 255.0 * intensity); }
std::string meanAndSpread(const HalfField& half) { return fmt::format("{:.3f} ± {:.3f}", half.mean, half.spread); }

TheorySetting with(TheorySetting setting, OpacityScaling scaling) {
    setting.scaling = scaling;
    return setting;
}

/// What each curve makes of the setting's model, by all kinds of contrast.
TextTable modelTable(const TheorySetting& setting) {
    TextTable table{
        {"curve", "opacity at c2", "opacity at c1", "C of fluid", "C into tissue", "difference", "Michelson", "Weber"}};
    for (const CurveContrast& one : contrastsOf(setting)) {
        std::vector<std::string> row{one.name, shareText(one.atFluid), shareText(one.atTissue),
                                     shareText(one.pixels.fluid), shareText(one.pixels.tissue)};
        for (const ContrastKind kind : allContrastKinds) row.push_back(shareText(contrastOf(one.pixels, kind)));
        table.rows.push_back(std::move(row));
    }
    return table;
}

/// From how many units of fluid on x^2 beats x: a row for each tissue, a column for each ratio.
TextTable crossingTable(const std::vector<CrossingRow>& rows) {
    TextTable table{{"c1", "tissue, units"}};
    for (const CrossingRow& row : rows) {
        const std::string column = fmt::format("c2/c1 {:.1f}", row.ratio);
        if (std::ranges::find(table.columns, column) == table.columns.end()) table.columns.push_back(column);
        const std::vector<std::string> key{level(row.tissue), std::to_string(row.tissueUnits)};
        if (table.rows.empty() || !std::equal(key.begin(), key.end(), table.rows.back().begin()))
            table.rows.push_back(key);
        table.rows.back().push_back(row.units ? fmt::format("{:.1f}", *row.units) : "-");
    }
    return table;
}

/// The largest distance of a pixel from theory, percent of white: a row for each model, a column for each curve.
TextTable errorTable(const std::vector<TheoryRow>& rows, OpacityScaling scaling) {
    TextTable table{{"fluid, units", "c2/c1"}};
    const TwoIntensities* model = nullptr;
    for (const TheoryRow& row : rows) {
        if (row.scaling != scaling) continue;
        if (std::ranges::find(table.columns, row.curve) == table.columns.end()) table.columns.push_back(row.curve);
        if (model == nullptr || !(*model == row.model))
            table.rows.push_back(
                {std::to_string(row.model.fluidUnits), fmt::format("{:.3f}", row.model.fluid / row.model.tissue)});
        model = &row.model;
        table.rows.back().push_back(percent(row.largestError()));
    }
    return table;
}

TextTable speckleTable(const std::vector<TheoryRow>& rows) {
    TextTable table{{"s", "speckle", "curve", "C of fluid", "of moments", "picture", "C into tissue", "of moments",
                     "picture", "difference", "picture", "to noise"}};
    for (const TheoryRow& row : rows)
        table.rows.push_back({fmt::format("{:.1f}", row.speckle), row.speckleSize > 0.0 ? "2 voxels" : "uncorrelated",
                              row.curve, shareText(row.theory.fluid), shareText(row.mean->fluid),
                              meanAndSpread(row.picture.fluid), shareText(row.theory.tissue),
                              shareText(row.mean->tissue), meanAndSpread(row.picture.tissue),
                              shareText(contrastOf(row.theory, ContrastKind::difference)), shareText(row.difference()),
                              shown(row.toNoise())});
    return table;
}

TextTable adaptiveTable(const std::vector<AdaptiveRow>& rows) {
    TextTable table{{"c1", "c2", "s", "tube cores with weight", "I_H", "I_L", "model: at c2", "at c1", "difference",
                     "volume: at c2", "at c1", "difference"}};
    for (const AdaptiveRow& row : rows)
        table.rows.push_back(
            {fmt::format("{:.1f}", 255.0 * row.model.tissue), fmt::format("{:.1f}", 255.0 * row.model.fluid),
             fmt::format("{:.1f}", row.speckle), fmt::format("{} of {}", row.withWeight, row.tubes),
             fmt::format("{:.1f}", 255.0 * row.high), fmt::format("{:.1f}", 255.0 * row.low),
             shareText(row.ofModel.atFluid), shareText(row.ofModel.atTissue), shareText(row.ofModel.contrast),
             shareText(row.ofVolume.atFluid), shareText(row.ofVolume.atTissue), shareText(row.ofVolume.contrast)});
    return table;
}

double largestError(const std::vector<TheoryRow>& rows) {
    double largest = 0.0;
    for (const TheoryRow& row : rows) largest = std::max(largest, row.largestError());
    return largest;
}

std::string modelWords(const TwoIntensities& model) {
    return fmt::format("Tissue c1 = {}, fluid c2 = {} (of 255), {} units of fluid, {} of tissue, black background.",
                       level(model.tissue), level(model.fluid), model.fluidUnits, model.tissueUnits);
}

std::string errorWords(const TheoryFindings& found) {
    return fmt::format("Without speckle the largest distance of a pixel from theory is {} % of white.",
                       percent(largestError(found.plain)));
}

void addModel(const TheoryFindings& found, HtmlPage& page) {
    const TheorySetting& setting = found.measure.setting;
    page.heading("The model");
    page.paragraph(modelWords(setting.model) +
                   " A ray takes one sample a unit: first fluid, then tissue up to its end. A ray beside it passes "
                   "through as much fluid only. C(r) follows by eqs. 2 and 3, white is intensity 1.");
    page.paragraph(
        "Contrast is the difference of both pixels as a share of white: what an eye sees on a screen. Michelson "
        "contrast (difference over sum) and Weber contrast (difference over the fluid's pixel) stand in the tables, "
        "but "
        "do not decide: they rise as the fluid turns black, however dark the tissue is.");
    page.plot(opacityPlot(setting));
    addTable(page, modelTable(with(setting, OpacityScaling::sameScale)), "The same a for all curves");
    addTable(page, modelTable(with(setting, OpacityScaling::sameAtTissue)),
             "The same opacity at c1 for all curves, that of the line");
}

void addCourses(const TheoryFindings& found, HtmlPage& page) {
    for (const OpacityScaling scaling : {OpacityScaling::sameScale, OpacityScaling::sameAtTissue}) {
        const TheorySetting setting = with(found.measure.setting, scaling);
        page.heading(scaling == OpacityScaling::sameScale ? "The same a for all curves" : "The same opacity at c1");
        page.paragraph(scaling == OpacityScaling::sameScale
                           ? "As the paper writes them: a x, a x², a x⁴. Eq. 1 has a = 0.5, as in Fig. 1b. Powers are "
                             "then also less opaque in tissue."
                           : "Every curve is multiplied until tissue is as opaque as under the line. Only the shape of "
                             "the curve is then compared.");
        page.paragraph(
            winnerSentence(setting) +
            " The adaptive curve is that of the model at each place, without speckle: the method itself finds "
            "no surface if c2 is too near c1 (the last table).");
        for (const CourseAxis axis : allCourseAxes) {
            const ContrastCourse course = courseOf(setting, axis);
            page.plot(contrastPlot(setting, course, axis));
            page.plot(pixelPlot(setting, course, axis));
        }
    }
}

void addCrossings(const TheoryFindings& found, HtmlPage& page) {
    page.heading("Where the parabola beats the line");
    page.paragraph(
        "The difference is D = (1 - α(c2))ⁿ (c1 A1 - c2 A2), n units of fluid, A1 and A2 the opacities of the tissue "
        "and of as much fluid. With the same opacity at c1, a parabola has less opacity at c2, so both factors are "
        "larger: it always beats the line. With the same a it has less opacity in tissue too, so dark or thin tissue "
        "behind thin fluid is shown better by the line. The table says from how many units of fluid on the parabola "
        "shows more; 0.0 is always.");
    addTable(page, crossingTable(found.crossings), "Units of fluid from which x² beats x, at the same a");
}

void addPictures(const TheoryFindings& found, HtmlPage& page) {
    page.heading("The same as pictures");
    page.paragraph(
        "Each volume has a layer of fluid before tissue on its right half, fluid alone on its left half. The program's "
        "ray caster renders it along +z: parallel rays through the centres of voxels, step 1, nearest voxel, linear "
        "greys, no light, rays that do not end early. " +
        errorWords(found));
    addTable(page, errorTable(found.plain, OpacityScaling::sameScale),
             "Largest distance of a pixel from eqs. 2 and 3, % of white, the same a");
    addTable(page, errorTable(found.plain, OpacityScaling::sameAtTissue), "The same opacity at c1");
}

void addSpeckle(const TheoryFindings& found, HtmlPage& page) {
    page.heading("Where speckle breaks it");
    page.paragraph(
        "Intensities are multiplied by 1 + s (R - 1), R Rayleigh of mean 1. A curve makes opacity of each voxel, and "
        "the mean of opacities is not the opacity of the mean: x² of a speckled voxel has the mean c² (1 + 0.273 s²). "
        "Brighter voxels are more opaque too, so pixels take more of their light from them. \"Of moments\" is eq. 3 "
        "with "
        "the means of α and c α: exact for uncorrelated speckle. Correlated speckle has thicker bright places along a "
        "ray, which the mean does not know. Pixels spread, and no mean says how far. \"To noise\" is the difference "
        "over "
        "the spread of both halves.");
    addTable(page, speckleTable(found.speckled));
}

void addAdaptive(const TheoryFindings& found, HtmlPage& page) {
    page.heading("The adaptive curve");
    page.paragraph(
        "Plots and tables above take the adaptive curve of one tube core that found the surface: I_L = c2, I_H = c1, "
        "default reading, no speckle. The table sets beside it what the whole method makes of the volume (speckle "
        "smoothed over 2 voxels), and the contrast of both curves in the model without speckle.");
    addTable(page, adaptiveTable(found.adaptive));
}

}  // namespace

std::string theoryPage(const TheoryFindings& found) {
    HtmlPage page("Section 4: contrast of two intensities");
    addModel(found, page);
    addCourses(found, page);
    addCrossings(found, page);
    addPictures(found, page);
    addSpeckle(found, page);
    addAdaptive(found, page);
    return page.text();
}

std::string theorySummary(const TheoryFindings& found) {
    const TheorySetting& setting = found.measure.setting;
    std::string text = modelWords(setting.model) + "\n";
    for (const OpacityScaling scaling : {OpacityScaling::sameScale, OpacityScaling::sameAtTissue})
        text += fmt::format("\n{}: {}\n{}", nameOf(scaling), winnerSentence(with(setting, scaling)),
                            plainText(modelTable(with(setting, scaling))));
    text += "\nUnits of fluid from which x² beats x, at the same a:\n" + plainText(crossingTable(found.crossings));
    for (const OpacityScaling scaling : {OpacityScaling::sameScale, OpacityScaling::sameAtTissue})
        text += fmt::format("\nLargest distance of a pixel from theory, % of white, {}:\n{}", nameOf(scaling),
                            plainText(errorTable(found.plain, scaling)));
    return text + errorWords(found) + "\n\nWith speckle:\n" + plainText(speckleTable(found.speckled)) +
           "\nThe adaptive curve of the model and of the volume:\n" + plainText(adaptiveTable(found.adaptive));
}

}  // namespace echolucent::cli
