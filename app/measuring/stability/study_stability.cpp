// `study stability`: every extreme case with its result and its reference.
#include "app/measuring/stability/study_stability.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <memory>

#include "app/measuring/study.h"
#include "processing/adaptive/method_reading.h"

namespace echolucent::cli {

namespace {

std::string digits(double value) { return fmt::format("{:.3g}", value); }

std::string numbersCsv(const std::vector<NumericCheck>& checks) {
    CsvTable csv({"quantity", "condition", "way", "value", "reference", "error", "allowed"});
    for (const NumericCheck& check : checks)
        csv.row({check.quantity, check.condition, check.way, check.value, check.reference,
                 std::isfinite(check.error) ? CsvCell(check.error) : CsvCell("infinite"), check.allowed});
    return csv.text();
}

std::string casesCsv(const std::vector<ExtremeResult>& results) {
    CsvTable csv({"case", "reading", "tubes", "surfaces", "finite", "least_opacity", "largest_opacity",
                  "largest_difference_from_initial", "sound", "message"});
    for (const ExtremeResult& result : results)
        csv.row({result.name, result.reading, result.tubes, result.surfaces, result.finite, result.leastOpacity,
                 result.mostOpacity, result.deviation, result.isSound(), result.message});
    return csv.text();
}

/// The error of the basis function over the gap.
Plot basisPlot(const std::vector<NumericCheck>& checks) {
    Plot plot{"Error of the basis function", "I_H - I_L", "largest error", true, true, {}};
    for (const bool here : {true, false}) {
        PlotSeries series;
        series.name = here ? "as here" : "eq. 6 literally";
        series.markers = true;
        for (const NumericCheck& check : checks) {
            if (!check.abscissa || check.isOurs() != here) continue;
            series.x.push_back(*check.abscissa);
            // A logarithmic axis has no 0. A value that is not finite is drawn at the top.
            series.y.push_back(std::clamp(check.error, 1e-18, 1e3));
        }
        plot.series.push_back(std::move(series));
    }
    return plot;
}

/// Enough digits of a reference to tell it from a double. The CSV tables hold all 50.
std::string shortened(const std::string& reference) {
    constexpr std::size_t shownDigits = 24;
    const auto exponent = std::min(reference.find('e'), reference.size());
    if (exponent <= shownDigits) return reference;
    return reference.substr(0, shownDigits) + "…" + reference.substr(exponent);
}

void addNumbers(const std::vector<NumericCheck>& checks, HtmlPage& page) {
    page.heading("Numbers");
    page.paragraph(
        "Each quantity is given as the program computes it, and as the textbook formula has it in the same precision. "
        "References have 50 digits (tests/fixtures holds the script that made them, stability-numbers.csv all digits) "
        "or are exact fractions. The error is the largest of its condition; value and reference are those of the place "
        "where it is.");
    page.plot(basisPlot(checks));
    for (auto first = checks.begin(); first != checks.end();) {
        const auto last = std::find_if(first, checks.end(),
                                       [&](const NumericCheck& check) { return check.quantity != first->quantity; });
        std::vector<std::vector<std::string>> rows;
        for (auto check = first; check != last; ++check)
            rows.push_back({check->condition, check->way, fmt::format("{:.17g}", check->value),
                            shortened(check->reference), digits(check->error),
                            check->allowed ? digits(*check->allowed) : "",
                            !check->isOurs() ? ""
                            : check->fails() ? "fails"
                                             : "holds"});
        page.table({"condition", "way", "value", "reference", "error", "allowed", ""}, rows, first->quantity);
        first = last;
    }
}

void addCases(const std::vector<ExtremeResult>& results, HtmlPage& page) {
    page.heading("Extreme volumes and settings");
    page.paragraph(
        "Each must end in a curve of opacities between 0 and 1, or in a sentence and the initial function; nothing may "
        "become NaN. The difference is the largest between the curve and the initial function.");
    std::vector<std::vector<std::string>> rows;
    rows.reserve(results.size());
    for (const ExtremeResult& result : results)
        rows.push_back({result.name, result.reading, std::to_string(result.tubes), std::to_string(result.surfaces),
                        result.finite ? "yes" : "no",
                        fmt::format("{:.4g} to {:.4g}", result.leastOpacity, result.mostOpacity),
                        digits(result.deviation), result.isSound() ? "sound" : "unsound",
                        result.message.empty() ? "a curve" : result.message});
    page.table({"case", "reading", "T", "surfaces with weight", "finite", "opacities", "difference", "", "result"},
               rows);
}

class StabilityStudy final : public StudyCommand {
public:
    StabilityStudy()
        : StudyCommand({"stability", "Extreme cases, each with its result and its reference", "stability -o study"}) {}

private:
    void addOptions(CLI::App& command) override { addFolder(command, "Folder for the page and the tables"); }
    std::vector<std::string> files() const override {
        return {"stability.html", "stability-numbers.csv", "stability-cases.csv"};
    }

    Result<StudyFindings> measure() override {
        const std::vector<NumericCheck> checks = numericChecks();
        std::vector<ExtremeResult> results;
        for (const ExtremeCase& extreme : extremeCases())
            for (const MethodReading reading : allReadings)
                results.push_back(resultOf(extreme, std::string(nameOf(reading)), configOf(reading)));
        HtmlPage page("Stability of the adaptive opacity transfer function");
        addNumbers(checks, page);
        addCases(results, page);
        const auto held = std::ranges::count_if(checks, &NumericCheck::isOurs);
        return StudyFindings{{{"stability.html", page.text()},
                              {"stability-numbers.csv", numbersCsv(checks)},
                              {"stability-cases.csv", casesCsv(results)}},
                             fmt::format("{} of {} numbers hold their bound, {} of {} extreme cases are sound: {}\n",
                                         held - std::ranges::count_if(checks, &NumericCheck::fails), held,
                                         std::ranges::count_if(results, &ExtremeResult::isSound), results.size(),
                                         pathOf("stability.html"))};
    }
};

}  // namespace

std::shared_ptr<StudyCommand> stabilityStudy() { return std::make_shared<StabilityStudy>(); }

}  // namespace echolucent::cli
