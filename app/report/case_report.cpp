#include "app/report/case_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/pages/html_page.h"
#include "app/report/first_page.h"
#include "app/report/paper_page.h"
#include "processing/adaptive/method_parameters.h"
#include "processing/designers/choice/designer.h"
#include "processing/picture/look.h"
#include "processing/scene/shown_measurement.h"
#include "widgets/casting/picture_image.h"

namespace echolucent {

namespace {

using Rows = std::vector<std::vector<std::string>>;

template <typename Values>
Rows rowsOf(const ParameterTable<Values>& table, const Values& values) {
    Rows rows;
    for (const Parameter<Values>& row : table)
        if (const auto value = row.get(values))
            rows.push_back({std::string(row.label), shownValue(row, *value), std::string(row.unit)});
    return rows;
}

/// Whose study it is, in one line.
template <typename Page>
void addPatient(Page& page, const CaseReport& report) {
    if (!report.patient) return;
    const Patient& patient = *report.patient;
    std::string facts;
    const auto add = [&facts](std::string_view words, const std::string& value) {
        if (!value.empty()) facts += fmt::format("{}{}{}", facts.empty() ? "" : " · ", words, value);
    };
    add("", patient.name);
    add("patient ID ", patient.id);
    add("born ", patient.birthDate);
    add("sex ", patient.sex);
    add("exam of ", patient.studyDate);
    add("gestational age ", patient.gestationalAge);
    if (!facts.empty()) page.paragraph("Patient: " + facts);
}

/// Names a phase of a 4D study behind other words, else nothing.
std::string volumeWords(const CaseReport& report, int phase) {
    return report.phases > 1 ? fmt::format(", volume {}", phase + 1) : std::string();
}

/// The 3D view first: it is the large one. Beside few texts all pictures are larger.
template <typename Page>
void addPictures(Page& page, const CaseReport& report, const FirstPageTexts& texts) {
    constexpr double fewTexts = 45.0;  // mm
    std::vector<PagePicture> row;
    for (const ReportPane& pane : report.panes) {
        PagePicture picture{pane.image.width(), pane.image.height(), rgbBytesOf(pane.image),
                            pane.caption.toStdString() + volumeWords(report, report.document.scene.phase)};
        row.insert(pane.is3d ? row.begin() : row.end(), std::move(picture));
    }
    page.pictures(row, row.size() > 1 && texts.heightMm <= fewTexts ? PictureRow::below : PictureRow::beside);
}

/// A measurement as the first page tells it, whose reader asks neither for its number nor for its places.
FirstPageRow rowOf(const Measurement& measurement, const CaseReport& report) {
    FirstPageRow row{.name = measurement.name, .value = {}, .unit = {}, .comment = measurement.comment};
    if (row.name.empty()) row.name = fmt::format("{} {}", nameOf(measurement.kind), measurement.id);
    row.name += volumeWords(report, measurement.phase);
    if (const auto number = measurementNumber(measurement, report.geometry)) {
        row.value = number->digits;
        row.unit = number->unit;
    } else {
        row.comment = number.error().sentence() + (row.comment.empty() ? "" : " ") + row.comment;
    }
    return row;
}

template <typename Page>
void addText(Page& page, const std::string& title, const std::string& text) {
    if (text.empty()) return;
    page.heading(title);
    page.lines(text);
}

template <typename Page>
void addFirstTexts(Page& page, const CaseReport& report, const FirstPageTexts& texts) {
    page.heading("Measurements");
    Rows rows;
    for (const FirstPageRow& row : texts.rows) rows.push_back({row.name, row.value, row.unit, row.comment});
    if (rows.empty() && texts.leftOut == 0)
        page.paragraph("Nothing was measured.");
    else
        page.table({"name", "value", "unit", "comment"}, rows, {}, {26, 12, 8, 54});
    addText(page, "Impression", texts.impression.text);
    addText(page, "Comment", texts.comment.text);
    QStringList continued;
    if (texts.leftOut > 0)
        continued
            << QStringLiteral("%1 more of %2 measurements").arg(texts.leftOut).arg(report.document.measurements.size());
    if (!texts.rowsAreWhole) continued << QStringLiteral("comments on measurements");
    if (!texts.impression.isWhole) continued << QStringLiteral("the impression");
    if (!texts.comment.isWhole) continued << QStringLiteral("the comment");
    if (!continued.isEmpty())
        page.paragraph((report.withAppendix ? "Continued in the appendix: " : "Continued on the next sheet: ") +
                       continued.join(QStringLiteral(", ")).toStdString() + ".");
}

/// The logarithm of the counts, so that rare intensities show beside the background. The highest value is 1.
PlotSeries histogramSeries(const IntensityHistogram& histogram) {
    PlotSeries series;
    series.name = "voxels (logarithm)";
    const double most = std::log1p(static_cast<double>(*std::ranges::max_element(histogram.counts)));
    for (std::size_t bin = 0; bin < histogram.counts.size(); ++bin) {
        series.x.push_back((static_cast<double>(bin) + 0.5) / static_cast<double>(histogram.counts.size()));
        series.y.push_back(most > 0.0 ? std::log1p(static_cast<double>(histogram.counts[bin])) / most : 0.0);
    }
    return series;
}

template <typename Page>
void addCurves(Page& page, const CaseReport& report) {
    constexpr int samples = 257;
    const CurveKind active = report.document.panes.at(firstPane).curve;
    const CurveSet curves = curvesOf(report.document, firstPane);
    Plot plot{.title = "Opacity transfer functions", .xLabel = "intensity", .yLabel = "opacity", .series = {}};
    for (const CurveKind kind : allCurveKinds) {
        if (kind == CurveKind::adaptive && report.adaptive.opacities.empty()) continue;
        const bool rendered = kind == active && report.designer.empty();
        const OpacityCurve curve =
            rendered ? renderedCurve(curves, kind, report.adaptive) : curveOf(curves, kind, report.adaptive);
        PlotSeries series;
        series.name = std::string(nameOf(kind)) + (rendered ? " (rendered)" : "");
        series.y = sampledOpacities(curve, samples);
        for (int i = 0; i < samples; ++i) series.x.push_back(static_cast<double>(i) / (samples - 1));
        plot.series.push_back(std::move(series));
    }
    if (report.designed) {
        PlotSeries series;
        series.name = report.designer + " (rendered)";
        series.y = sampledOpacities(adjusted(*report.designed, report.document.curves.adjustment), samples);
        for (int i = 0; i < samples; ++i) series.x.push_back(static_cast<double>(i) / (samples - 1));
        plot.series.push_back(std::move(series));
    }
    plot.series.push_back(histogramSeries(report.histogram));
    page.heading("Curves");
    page.plot(plot);
    page.paragraph(
        report.designer.empty()
            ? fmt::format("The 3D view is rendered with the {} curve.", nameOf(active))
            : fmt::format("The 3D view is rendered with the OTF of the designer {}; the plot shows its largest "
                          "opacity of each intensity.",
                          report.designer));
}

std::string placesText(const std::vector<Vec3>& places) {
    std::string text;
    for (const Vec3& place : places)
        text += fmt::format("{}({:.2f}, {:.2f}, {:.2f})", text.empty() ? "" : " – ", place[0], place[1], place[2]);
    return text;
}

template <typename Page>
void addMeasurements(Page& page, const CaseReport& report) {
    if (report.document.measurements.empty()) return;
    page.heading("Measurements and their places");
    Rows rows;
    for (const Measurement& measurement : report.document.measurements) {
        const auto value = measurementText(measurement, report.geometry);
        rows.push_back({std::to_string(measurement.id), std::string(nameOf(measurement.kind)), measurement.name,
                        value ? *value : value.error().sentence(), std::string(groundWords(measurement.ground)),
                        std::to_string(measurement.phase + 1), placesText(measurement.placesMm), measurement.comment});
    }
    page.table({"number", "kind", "name", "value", "marked", "volume", "places (mm of the grid)", "comment"}, rows);
}

template <typename Page>
void addParameters(Page& page, const CaseReport& report) {
    page.heading("Parameters");
    const std::vector<std::string> columns{"parameter", "value", "unit"};
    page.table(columns, rowsOf(methodParameters(), configOf(report.document)), "The adaptive method");
    if (report.designedWith) {
        const auto rows =
            std::visit([](const auto& values) { return rowsOf(parametersOf(values), values); }, *report.designedWith);
        if (!rows.empty()) page.table(columns, rows, "The designer " + report.designer);
    }
    page.table(columns, rowsOf(lookParameters(), report.document.scene.look), "The look of the 3D view");
}

template <typename Page>
void addImport(Page& page, const CaseReport& report) {
    page.heading("Import report");
    for (const std::string& warning : report.warnings) page.paragraph("Warning: " + warning);
    Rows rows;
    for (const ImportFact& fact : report.facts) rows.push_back({fact.name, fact.value, fact.source});
    page.table({"fact", "value", "where it is from"}, rows);
}

template <typename Page>
void addTimes(Page& page, const CaseReport& report) {
    if (report.times.empty()) return;
    page.heading("Timings");
    Rows rows;
    for (const ReportTime& time : report.times)
        rows.push_back({time.what.toStdString(), fmt::format("{:.1f}", time.milliseconds)});
    page.table({"what", "milliseconds"}, rows, "Wall time on the machine that made this report");
}

/// The parts of a report in their order, on a page of HTML or on paper.
template <typename Page>
void addReport(Page& page, const CaseReport& report) {
    const std::string made =
        fmt::format("Made on {} with Echolucent {}. Not a medical device: not for diagnosis or treatment.",
                    report.made.toStdString(), report.version.toStdString());
    std::vector<FirstPageRow> rows;
    for (const Measurement& measurement : report.document.measurements) rows.push_back(rowOf(measurement, report));
    const FirstPageTexts texts = textsOfFirstPage(rows, report.impression, report.comment);
    const bool tableIsWhole = texts.leftOut == 0 && texts.rowsAreWhole;
    page.beginSheet();
    page.paragraph(made);
    addPatient(page, report);
    addPictures(page, report, texts);
    addFirstTexts(page, report, texts);
    if (!report.withAppendix && tableIsWhole && texts.impression.isWhole && texts.comment.isWhole) return;
    page.appendix((report.withAppendix ? "Appendix: " : "Continued: ") + report.study.toStdString());
    page.paragraph(made);
    if (!texts.impression.isWhole) addText(page, "Impression, whole", report.impression);
    if (!texts.comment.isWhole) addText(page, "Comment, whole", report.comment);
    if (report.withAppendix) {
        page.heading("What the picture shows");
        for (const QString& sentence : report.explanation) page.paragraph(sentence.toStdString());
    }
    if (report.withAppendix || !tableIsWhole) addMeasurements(page, report);
    if (!report.withAppendix) return;
    addCurves(page, report);
    addParameters(page, report);
    addImport(page, report);
    addTimes(page, report);
}

std::string titleOf(const CaseReport& report) { return "Case report: " + report.study.toStdString(); }

}  // namespace

std::string caseReportPage(const CaseReport& report) {
    HtmlPage page(titleOf(report), HtmlPage::anyBytes);
    addReport(page, report);
    return page.text();
}

std::optional<std::string> caseReportPdf(const CaseReport& report, const Progress& progress) {
    PaperPage page(titleOf(report));
    addReport(page, report);
    return page.pdf("Echolucent " + report.version.toStdString(), progress);
}

}  // namespace echolucent
