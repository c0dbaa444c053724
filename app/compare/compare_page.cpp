#include "app/compare/compare_page.h"

#include <fmt/format.h>

#include "app/pages/html_page.h"
#include "widgets/casting/picture_image.h"
#include "widgets/surface_colours.h"

namespace echolucent {

namespace {

std::string nameAt(const ComparePage& page, std::size_t index) {
    const ComparePage::Pane& pane = page.panes[index];
    return fmt::format("{}: {}", pane.place + 1, pane.row.name.toStdString());
}

void addCurves(HtmlPage& html, const ComparePage& page) {
    constexpr int samples = 257;
    Plot plot{.title = "Opacity transfer functions", .xLabel = "intensity", .yLabel = "opacity", .series = {}};
    for (std::size_t place = 0; place < page.panes.size(); ++place) {
        PlotSeries series;
        series.name = nameAt(page, place);
        series.colour = page.panes[place].colour;
        series.y = sampledOpacities(upperCurveOf(page.panes[place].classification), samples);
        for (int i = 0; i < samples; ++i) series.x.push_back(static_cast<double>(i) / (samples - 1));
        plot.series.push_back(std::move(series));
    }
    html.heading("Curves");
    html.plot(plot);
    for (const ComparePage::Pane& pane : page.panes)
        if (pane.classification.isTwoDimensional())
            return html.paragraph(
                "Of an OTF over intensity and gradient magnitude the plot shows the largest opacity of "
                "each intensity.");
}

}  // namespace

std::string comparePageText(const ComparePage& page) {
    HtmlPage html("Comparison: " + page.study.toStdString(), HtmlPage::anyBytes);
    html.paragraph(fmt::format("Made on {} with Echolucent {}. Not a medical device: not for diagnosis or treatment.",
                               page.made.toStdString(), page.version.toStdString()));
    html.heading("Pictures");
    html.paragraph(
        "All pictures have one camera, cut, box and light; they differ in their OTF alone, or in their volume "
        "if it is named.");
    if (!page.seen.isEmpty()) html.paragraph(page.seen.join(QLatin1Char(' ')).toStdString());
    if (page.coloured) html.paragraph(surfaceColoursSentence().toStdString());
    for (std::size_t place = 0; place < page.panes.size(); ++place) {
        const QImage& image = page.panes[place].image;
        if (!image.isNull()) html.picture(image.width(), image.height(), rgbBytesOf(image), nameAt(page, place));
    }
    html.heading("Table");
    std::vector<std::string> columns;
    for (const QString& column : compareColumns()) columns.push_back(column.toStdString());
    std::vector<std::vector<std::string>> rows;
    for (const ComparePage::Pane& pane : page.panes) {
        rows.emplace_back();
        for (const QString& cell : cellsOf(pane.row)) rows.back().push_back(cell.toStdString());
    }
    html.table(columns, rows, "What is measured of each pane");
    std::vector<CompareRow> measured;
    for (const ComparePage::Pane& pane : page.panes) measured.push_back(pane.row);
    if (const QString sentence = surfacesSentence(measured); !sentence.isEmpty())
        html.paragraph(sentence.toStdString());
    for (const QString& tip : compareTips())
        if (!tip.isEmpty()) html.paragraph(tip.toStdString());
    html.paragraph(flickerSentences().toStdString() + " Times are wall time on the machine that made this page.");
    addCurves(html, page);
    html.heading("Why the OTFs are as they are");
    for (std::size_t place = 0; place < page.panes.size(); ++place) {
        const ComparePage::Pane& pane = page.panes[place];
        if (!pane.explanation.isEmpty())
            html.paragraph(nameAt(page, place) + ". " + pane.explanation.join(QLatin1Char(' ')).toStdString());
        if (!pane.parameters.isEmpty())
            html.paragraph(fmt::format("Parameters of {}. {}", pane.place + 1, pane.parameters.toStdString()));
    }
    return html.text();
}

}  // namespace echolucent
