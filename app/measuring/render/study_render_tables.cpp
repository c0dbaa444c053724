#include <fmt/format.h>

#include <algorithm>

#include "app/measuring/render/study_render.h"

namespace echolucent::cli {

namespace {

std::string levels(double value) { return fmt::format("{:.3g}", value); }
std::string milliseconds(const RenderResult& result) {
    return result.milliseconds < 100.0 ? levels(result.milliseconds) : fmt::format("{:.0f}", result.milliseconds);
}
std::string ratio(const RenderResult& result) { return fmt::format("{:.3g}", result.timeRatio); }
std::string similarity(double value) { return fmt::format("{:.5f}", value); }

std::vector<std::string> rowOf(const RenderResult& result) {
    return {result.letter,
            result.variant.axis,
            result.variant.value,
            milliseconds(result),
            ratio(result),
            levels(result.error.rmse),
            levels(result.error.largest),
            similarity(result.error.ssim),
            result.onFront ? "●" : ""};
}

const std::vector<std::string> variantColumns{"",     "parameter", "value", "time, ms", "time ratio",
                                              "RMSE", "maximum",   "SSIM",  "front"};

}  // namespace

std::string renderCsv(const RenderStudy& study) {
    CsvTable table({"letter",        "route",     "parameter",   "value",          "step",
                    "interpolation", "precision", "termination", "skipping",       "whole_steps",
                    "reduction",     "width",     "height",      "time_ms",        "time_ratio",
                    "rmse",          "maximum",   "ssim",        "precision_rmse", "precision_maximum",
                    "front"});
    for (const RenderResult& result : study.results) {
        const RenderVariant& variant = result.variant;
        const RayCastSettings& settings = variant.settings;
        const auto& fromDouble = result.precisionError;
        table.row({result.letter,
                   variant.plain ? "plain" : "kernel",
                   variant.axis,
                   variant.value,
                   settings.step,
                   settings.interpolation == Interpolation::nearest ? "nearest" : "trilinear",
                   nameOf(variant.precision),
                   settings.terminationTransmittance,
                   settings.skipEmptySpace,
                   variant.plain && variant.plain->wholeSteps,
                   variant.reduction,
                   settings.width,
                   settings.height,
                   result.milliseconds,
                   result.timeRatio,
                   result.error.rmse,
                   result.error.largest,
                   result.error.ssim,
                   fromDouble ? std::optional(fromDouble->rmse) : std::nullopt,
                   fromDouble ? std::optional(fromDouble->largest) : std::nullopt,
                   result.onFront});
    }
    return table.text();
}

TextTable settingsTable(const RenderStudy& study) {
    TextTable table{variantColumns, {}};
    for (const RenderResult& result : study.results)
        if (!result.variant.plain) table.rows.push_back(rowOf(result));
    return table;
}

TextTable frontTable(const RenderStudy& study) {
    std::vector<const RenderResult*> front;
    for (const RenderResult& result : study.results)
        if (result.onFront) front.push_back(&result);
    std::sort(front.begin(), front.end(),
              [](const auto* a, const auto* b) { return a->milliseconds < b->milliseconds; });
    TextTable table{variantColumns, {}};
    table.columns.pop_back();
    for (const RenderResult* result : front) {
        table.rows.push_back(rowOf(*result));
        table.rows.back().pop_back();
    }
    return table;
}

TextTable boundsTable(const RenderStudy& study) {
    TextTable table{{"quality", "RMSE at most", "maximum at most", "fastest setting", "time, ms", "frames/s", "RMSE",
                     "maximum", "SSIM"},
                    {}};
    for (const QualityBound& bound : qualityBounds()) {
        const bool anyLargest = bound.largest == std::numeric_limits<double>::infinity();
        std::vector<std::string> row{bound.name, levels(bound.rmse), anyLargest ? "-" : levels(bound.largest)};
        if (const RenderResult* result = fastestWithin(bound, study.results))
            row.insert(row.end(), {fmt::format("{}: {}", result->letter, result->variant.name()), milliseconds(*result),
                                   fmt::format("{:.3g}", 1000.0 / result->milliseconds), levels(result->error.rmse),
                                   levels(result->error.largest), similarity(result->error.ssim)});
        else
            row.insert(row.end(), {"none", "-", "-", "-", "-", "-"});
        table.rows.push_back(std::move(row));
    }
    return table;
}

TextTable precisionTable(const RenderStudy& study) {
    TextTable table{{"", "stored as", "time ratio, plain", "RMSE", "maximum", "SSIM", "RMSE from double, same samples",
                     "maximum from double"},
                    {}};
    for (const RenderResult& result : study.results)
        if (result.variant.plain) {
            const auto& fromDouble = result.precisionError;
            table.rows.push_back({result.letter, result.variant.value, ratio(result), levels(result.error.rmse),
                                  levels(result.error.largest), similarity(result.error.ssim),
                                  fromDouble ? levels(fromDouble->rmse) : "-",
                                  fromDouble ? levels(fromDouble->largest) : "-"});
        }
    return table;
}

std::string sameRaysText(const RenderStudy& study) {
    std::string text = fmt::format(
        "The same rays: largest difference between the kernel's and the plain route's picture at equal settings: "
        "{:.3g} levels (RMSE {:.3g})",
        study.sameRays.front().error.largest, study.sameRays.front().error.rmse);
    for (std::size_t i = 1; i < study.sameRays.size(); ++i)
        text += fmt::format("; {}: {:.3g} (RMSE {:.3g})", study.sameRays[i].name, study.sameRays[i].error.largest,
                            study.sameRays[i].error.rmse);
    return text + ".";
}

std::string summaryText(const RenderStudy& study) {
    return study.subject + "\n" + sameRaysText(study) + "\n\nThe front of the kernel's settings\n" +
           plainText(frontTable(study)) + "\nThe fastest setting within each bound\n" + plainText(boundsTable(study)) +
           "\nCompositing precision, and whole steps only, by the plain route\n" + plainText(precisionTable(study));
}

}  // namespace echolucent::cli
