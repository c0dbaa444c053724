#include <fmt/format.h>

#include <algorithm>

#include "app/measuring/designers/study_designers.h"
#include "app/measuring/study_output.h"
#include "app/measuring/study_phantoms.h"
#include "processing/median.h"

namespace echolucent::cli {

namespace {

std::string labelOfName(const std::string& name) {
    const auto designer = designerFromName(name);
    return designer ? std::string(labelOf(*designer)) : "x²";
}

/// CNR_S by designer and condition, as mean over the seeds. The last columns are the mean over the conditions, and ms.
TextTable contrastTable(const DesignersStudy& study) {
    TextTable table{{"designer"}, {}};
    const auto conditions = namesIn(study.contrasts, [](const ContrastRow& row) { return row.condition; });
    table.columns.insert(table.columns.end(), conditions.begin(), conditions.end());
    table.columns.insert(table.columns.end(), {"mean", "ms"});
    for (const std::string& designer : namesIn(study.contrasts, [](const ContrastRow& row) { return row.designer; })) {
        std::vector<std::string> cells{labelOfName(designer)};
        std::vector<std::optional<double>> means;
        std::vector<double> times;
        for (const std::string& condition : conditions) {
            std::vector<std::optional<double>> seeds;
            for (const ContrastRow& row : study.contrasts)
                if (row.designer == designer && row.condition == condition) {
                    seeds.push_back(row.contrast);
                    times.push_back(row.milliseconds);
                }
            means.push_back(meanOf(seeds));
            cells.push_back(shown(means.back()));
        }
        cells.push_back(shown(meanOf(means)));
        cells.push_back(fmt::format("{:.1f}", medianOf(times)));
        table.rows.push_back(std::move(cells));
    }
    return table;
}

TextTable shownTable(const DesignersStudy::Shown& one) {
    TextTable table{{"designer", "dimensions", "ms", "picture, ms", "picture, times x²", "RMSE", "largest",
                     "CNR_S by tube cores", "light near surfaces"},
                    {}};
    for (const DesignerPicture& each : one.pictures) {
        const bool two = each.made.design.classification.isTwoDimensional();
        table.rows.push_back({labelOfName(each.designer), two ? "2" : "1",
                              fmt::format("{:.1f}", each.made.milliseconds),
                              fmt::format("{:.1f}", each.castMilliseconds),
                              fmt::format("{:.2f}", each.castMilliseconds / one.pictures.front().castMilliseconds),
                              fmt::format("{:.3f}", each.error.rmse), fmt::format("{:.1f}", each.error.largest),
                              each.measures ? shown(each.measures->contrast.contrastToNoise()) : "-",
                              each.measures ? fmt::format("{:.0f} %", 100.0 * each.measures->light.meanShare) : "-"});
    }
    return table;
}

Plot curvesPlot(const DesignersStudy::Shown& one) {
    Plot plot{.title = "Opacity per unit; of two-dimensional OTFs the largest at any gradient",
              .xLabel = "normalised intensity",
              .yLabel = "opacity",
              .series = {}};
    for (const DesignerPicture& each : one.pictures)
        plot.series.push_back(
            curveSeries(each.designer, sampledOpacities(upperCurveOf(each.made.design.classification), 256)));
    return plot;
}

void addShown(HtmlPage& page, const DesignersStudy::Shown& one) {
    page.heading(one.name);
    for (const DesignerPicture& each : one.pictures) page.picture(each.picture, labelOfName(each.designer));
    addTable(page, shownTable(one));
    page.plot(curvesPlot(one));
    for (const DesignerPicture& each : one.pictures) {
        std::string text = labelOfName(each.designer) + ":";
        for (const std::string& sentence : each.made.design.explanation) text += " " + sentence;
        if (!each.made.design.message.empty()) text += " " + each.made.design.message;
        if (text.back() != ':') page.paragraph(text);
    }
}

}  // namespace

std::string designersCsv(const DesignersStudy& study) {
    CsvTable csv({"designer", "condition", "seed", "contrast", "ms"});
    for (const ContrastRow& row : study.contrasts)
        csv.row({row.designer, row.condition, row.seed, row.contrast, row.milliseconds});
    for (const DesignersStudy::Shown& one : study.shown)
        for (const DesignerPicture& each : one.pictures)
            csv.row({each.designer, one.name, std::optional<double>(),
                     each.measures ? each.measures->contrast.contrastToNoise() : std::nullopt, each.made.milliseconds});
    return csv.text();
}

std::string designersPage(const DesignersStudy& study) {
    HtmlPage page("OTF designers side by side");
    if (!study.contrasts.empty()) {
        page.paragraph(fmt::format(
            "CNR_S says how well a picture sets the true surface off from haze before it and leakage behind it "
            "(docs/experiments.md). The table holds means over the seeds {} of the simulated shapes, speckle reduction "
            "{}; ms are wall time of the designer, the median of {} runs each, on whatever machine made this page.",
            study.seeds, nameOf(study.reduction), study.repeats));
        addTable(page, contrastTable(study));
    }
    page.paragraph(
        "Pictures are lit by light that reaches. Their time is the median of pictures that are cast anew, also as "
        "multiples of x²'s; RMSE and the largest error, in levels of 255, are those of a small picture by the ray "
        "caster from the plain route in double. CNR_S by tube cores and the light near surfaces take the surfaces that "
        "the tube cores found for true, which favours the adaptive OTF: it is made of these very surfaces.");
    for (const DesignersStudy::Shown& one : study.shown) addShown(page, one);
    return page.text();
}

std::string designersSummary(const DesignersStudy& study) {
    std::string text;
    if (!study.contrasts.empty()) text += plainText(contrastTable(study));
    for (const DesignersStudy::Shown& one : study.shown) text += "\n" + one.name + "\n" + plainText(shownTable(one));
    return text;
}

}  // namespace echolucent::cli
