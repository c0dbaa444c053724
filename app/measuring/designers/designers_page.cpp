#include <fmt/format.h>

#include <algorithm>

#include "app/measuring/designers/study_designers.h"
#include "app/measuring/study_output.h"
#include "app/measuring/study_phantoms.h"
#include "processing/median.h"

namespace echolucent::cli {

namespace {

/// CNR_S by designer and condition, as mean over the seeds. The last columns are the mean over the conditions, and ms.
TextTable contrastTable(const DesignersStudy& study) {
    TextTable table{{"designer"}, {}};
    const auto conditions = namesIn(study.rows, [](const DesignerRow& row) { return row.condition; });
    table.columns.insert(table.columns.end(), conditions.begin(), conditions.end());
    table.columns.insert(table.columns.end(), {"mean", "ms"});
    for (const std::string& designer : namesIn(study.rows, [](const DesignerRow& row) { return row.designer; })) {
        std::vector<std::string> cells{labelOfCompared(designer)};
        std::vector<std::optional<double>> means;
        std::vector<double> times;
        for (const std::string& condition : conditions) {
            std::vector<std::optional<double>> seeds;
            for (const DesignerRow& row : study.rows)
                if (row.designer == designer && row.condition == condition) {
                    seeds.push_back(row.surfaces.truth->contrast);
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

/// What the OTFs show on the scans of the table of contrasts, under the names of ComparedDesigner.
std::vector<NamedSurfaces> surfacesOf(const DesignersStudy& study) {
    std::vector<NamedSurfaces> all;
    for (const DesignerRow& row : study.rows) all.push_back({row.designer, row.condition, row.surfaces});
    return all;
}
std::vector<NamedSurfaces> surfacesOf(const DesignersStudy::Shown& one) {
    std::vector<NamedSurfaces> all;
    for (const DesignerPicture& each : one.pictures) all.push_back({each.designer, one.name, each.surfaces});
    return all;
}

std::vector<NamedSurfaces> labelled(std::vector<NamedSurfaces> rows) {
    for (NamedSurfaces& row : rows) row.name = labelOfCompared(row.name);
    return rows;
}

TextTable shownTable(const DesignersStudy::Shown& one) {
    TextTable table{{"designer", "dimensions", "ms", "picture, ms", "picture, times x²", "RMSE", "largest",
                     "CNR_S by tube cores", "light near surfaces"},
                    {}};
    for (const DesignerPicture& each : one.pictures) {
        const ClassificationMeasures& found = each.surfaces.tubeCores;
        const bool two = each.made.design.classification.isTwoDimensional();
        table.rows.push_back({labelOfCompared(each.designer), two ? "2" : "1",
                              fmt::format("{:.1f}", each.made.milliseconds),
                              fmt::format("{:.1f}", each.castMilliseconds),
                              fmt::format("{:.2f}", each.castMilliseconds / one.pictures.front().castMilliseconds),
                              fmt::format("{:.3f}", each.error.rmse), fmt::format("{:.1f}", each.error.largest),
                              shown(found.contrast.contrastToNoise()),
                              found.depth.rays() > 0 ? fmt::format("{:.0f} %", 100.0 * found.light.meanShare) : "-"});
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
    for (const DesignerPicture& each : one.pictures) page.picture(each.picture, labelOfCompared(each.designer));
    addTable(page, shownSurfaceTable(labelled(surfacesOf(one))));
    for (const std::string& sentence : besideAdaptive(surfacesOf(one))) page.paragraph(sentence);
    addTable(page, shownTable(one));
    page.plot(curvesPlot(one));
    for (const DesignerPicture& each : one.pictures) {
        std::string text = labelOfCompared(each.designer) + ":";
        for (const std::string& sentence : each.made.design.explanation) text += " " + sentence;
        if (!each.made.design.message.empty()) text += " " + each.made.design.message;
        if (text.back() != ':') page.paragraph(text);
    }
}

}  // namespace

std::string designersCsv(const DesignersStudy& study) {
    std::vector<std::string> columns{"designer", "condition", "seed"};
    for (std::string& column : shownSurfaceColumns()) columns.push_back(std::move(column));
    columns.insert(columns.end(), {"contrast", "ms"});
    CsvTable csv(columns);
    const auto add = [&](std::vector<CsvCell> cells, const ShownSurfaces& surfaces,
                         const std::optional<double>& contrast, double milliseconds) {
        for (CsvCell& cell : shownSurfaceCells(surfaces)) cells.push_back(std::move(cell));
        cells.emplace_back(contrast);
        cells.emplace_back(milliseconds);
        csv.row(cells);
    };
    for (const DesignerRow& row : study.rows)
        add({row.designer, row.condition, row.seed}, row.surfaces, row.surfaces.truth->contrast, row.milliseconds);
    for (const DesignersStudy::Shown& one : study.shown)
        for (const DesignerPicture& each : one.pictures)
            add({each.designer, one.name, std::optional<double>()}, each.surfaces,
                each.surfaces.tubeCores.contrast.contrastToNoise(), each.made.milliseconds);
    return csv.text();
}

std::string designersPage(const DesignersStudy& study) {
    HtmlPage page("OTF designers side by side");
    if (!study.rows.empty()) {
        const auto surfaces = labelled(surfacesOf(study));
        page.paragraph(fmt::format(
            "The shown depth of a ray is where half of the light is held back (docs/comparison.md). Against the ray's "
            "first surface behind fluid it is right (within 2 units), early, late, or never there. Objects are bright, "
            "walls are darker tissue; all are both. Tables hold means over the seeds {} of the simulated shapes, "
            "speckle reduction {}.",
            study.seeds, nameOf(study.reduction)));
        if (const auto named = namesIn(study.rows, [](const DesignerRow& row) { return row.designer; });
            std::ranges::find(named, nameOfAim(endsOfAim[0])) != named.end())
            page.paragraph(
                "The adaptive OTF stands there as it is chosen, and with an aim of 0 (bright surfaces) and of 1 (every "
                "wall).");
        addTable(page, shownSurfaceTable(surfaces));
        for (const std::string& sentence : besideAdaptive(surfacesOf(study))) page.paragraph(sentence);
        page.paragraph(
            "The same, what is right of all surfaces by the truth, and of the surfaces that tube cores find, which "
            "stand "
            "in for the truth on real scans.");
        addTable(page, rightTable(surfaces, SurfaceKind::all));
        addTable(page, rightTable(surfaces, SurfaceKind::tubeCores));
        if (const std::string sentence = rankSentence(surfaces); !sentence.empty()) page.paragraph(sentence);
        page.paragraph(fmt::format(
            "CNR_S says how equally bright the surfaces of objects are, and how much brighter than the light from "
            "elsewhere (docs/comparison.md). It favours curves that show few surfaces evenly and says nothing of where "
            "the picture stands. ms are wall time of the designer, the median of {} runs each, on whatever machine "
            "made "
            "this page.",
            study.repeats));
        addTable(page, contrastTable(study));
    }
    page.paragraph(
        "Pictures are lit by light that reaches. Their time is the median of pictures that are cast anew, also as "
        "multiples of x²'s; RMSE and the largest error, in levels of 255, are those of a small picture by the ray "
        "caster from the plain route in double. CNR_S and the light near surfaces are those of the surfaces that tube "
        "cores find, which favours the adaptive OTF: it is made of such surfaces.");
    for (const DesignersStudy::Shown& one : study.shown) addShown(page, one);
    return page.text();
}

std::string designersSummary(const DesignersStudy& study) {
    std::string text;
    if (!study.rows.empty()) {
        const auto surfaces = labelled(surfacesOf(study));
        text += plainText(shownSurfaceTable(surfaces)) + "\n";
        for (const std::string& sentence : besideAdaptive(surfacesOf(study))) text += sentence + "\n";
        text += "\n" + plainText(rightTable(surfaces, SurfaceKind::all)) + "\n" +
                plainText(rightTable(surfaces, SurfaceKind::tubeCores)) + "\n" + rankSentence(surfaces) +
                "\n\nCNR_S of objects by the truth\n" + plainText(contrastTable(study));
    }
    for (const DesignersStudy::Shown& one : study.shown) {
        text += "\n" + one.name + "\n" + plainText(shownSurfaceTable(labelled(surfacesOf(one)))) + "\n";
        for (const std::string& sentence : besideAdaptive(surfacesOf(one))) text += sentence + "\n";
        text += "\n" + plainText(shownTable(one));
    }
    return text;
}

}  // namespace echolucent::cli
