#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <string>
#include <vector>

#include "app/measuring/otf/study_otf.h"
#include "processing/adaptive/method_reading.h"

namespace echolucent::cli {

namespace {

std::string percent(double share) { return fmt::format("{:.2f}", 100.0 * share); }

/// CNR_S, or a dash.
std::string value(const std::optional<double>& number) { return shown(number, "—"); }

/// Adds up the quality of a reading over the results that `belongs` picks.
template <typename Belongs>
DetectionQuality pooled(const OtfStudy& study, MethodReading reading, Belongs belongs) {
    DetectionQuality quality;
    for (const ReadingResult& result : study.readings)
        if (result.reading == reading && belongs(result)) quality.add(result.detection);
    return quality;
}

template <typename Belongs>
std::vector<std::string> detectionRow(const OtfStudy& study, const std::string& name, Belongs belongs) {
    std::vector<std::string> row{name};
    std::array<DetectionQuality, allReadings.size()> qualities;
    for (std::size_t r = 0; r < allReadings.size(); ++r) qualities[r] = pooled(study, allReadings[r], belongs);
    for (const auto& quality : qualities)
        row.push_back(quality.tubesWithInterface > 0 && quality.weight > 0 ? percent(quality.rightShare()) : "—");
    for (const auto& quality : qualities) row.push_back(quality.weight > 0 ? percent(quality.emptyShare()) : "—");
    for (const auto& quality : qualities)
        row.push_back(quality.tubesWithInterface > 0 ? percent(quality.foundShare()) : "—");
    for (const auto& quality : qualities) row.push_back(fmt::format("{:.3f}", quality.weight));
    return row;
}

std::vector<std::optional<double>> contrastsOfReading(const OtfStudy& study, MethodReading reading,
                                                      const std::string& condition) {
    std::vector<std::optional<double>> values;
    for (const ReadingResult& result : study.readings)
        if (result.reading == reading && result.condition == condition && result.contrast)
            values.push_back(result.contrast);
    return values;
}

}  // namespace

TextTable variantTable(const OtfStudy& study) {
    TextTable table{{"interface function", "setting", "front", "run time", "ms", "RMS Δα", "max Δα"}, {}};
    if (study.truthKnown)
        for (const char* column : {"right weight %", "wrong weight %", "tubes found %", "|error| units"})
            table.columns.emplace_back(column);
    for (const VariantResult& result : study.variants) {
        const DetectionQuality& detection = result.detection;
        table.rows.push_back({result.variant.interfaceFunction, result.variant.name(), result.onFront ? "●" : "",
                              fmt::format("{:.2f}×", result.timeRatio()), fmt::format("{:.2f}", result.time()),
                              fmt::format("{:.4f}", result.rmsDifference()),
                              fmt::format("{:.4f}", result.largestDifference)});
        if (study.truthKnown)
            for (const std::string& cell :
                 {percent(detection.rightShare()), percent(detection.weight > 0 ? 1 - detection.rightShare() : 0.0),
                  percent(detection.foundShare()), fmt::format("{:.2f}", detection.meanDistanceUnits())})
                table.rows.back().push_back(cell);
    }
    return table;
}

TextTable detectionTable(const OtfStudy& study) {
    TextTable table{{"condition"}, {}};
    for (const char* what : {"right %", "on none %", "found %", "Σd"})
        for (const MethodReading reading : allReadings)
            table.columns.push_back(reading == allReadings.front() ? fmt::format("{}: {}", what, nameOf(reading))
                                                                   : std::string(nameOf(reading)));
    for (const std::string& group : namesIn(study.readings, [](const auto& result) { return result.group; })) {
        std::vector<ReadingResult> ofGroup;
        std::ranges::copy_if(study.readings, std::back_inserter(ofGroup),
                             [&](const ReadingResult& result) { return result.group == group; });
        const auto conditions = namesIn(ofGroup, [](const ReadingResult& result) { return result.condition; });
        for (const std::string& condition : conditions)
            table.rows.push_back(detectionRow(study, condition, [&](const ReadingResult& result) {
                return result.group == group && result.condition == condition;
            }));
        if (conditions.size() > 1)
            table.rows.push_back(detectionRow(study, "all " + group,
                                              [&](const ReadingResult& result) { return result.group == group; }));
    }
    return table;
}

TextTable contrastTable(const OtfStudy& study) {
    TextTable table{{"condition", "x²", "eq. 1"}, {}};
    for (const MethodReading reading : allReadings) table.columns.emplace_back(nameOf(reading));
    std::vector<std::vector<std::optional<double>>> columns(table.columns.size() - 1);
    for (const std::string& condition : namesIn(study.fixed, [](const auto& fixed) { return fixed.condition; })) {
        std::vector<std::optional<double>> parabola, linear;
        for (const FixedContrast& fixed : study.fixed)
            if (fixed.condition == condition) {
                parabola.push_back(fixed.parabola);
                linear.push_back(fixed.linear);
            }
        std::vector<std::optional<double>> means{meanOf(parabola), meanOf(linear)};
        for (const MethodReading reading : allReadings)
            means.push_back(meanOf(contrastsOfReading(study, reading, condition)));
        table.rows.push_back({condition});
        for (std::size_t c = 0; c < means.size(); ++c) {
            table.rows.back().push_back(value(means[c]));
            columns[c].push_back(means[c]);
        }
    }
    table.rows.push_back({"mean"});
    for (const auto& column : columns) table.rows.back().push_back(value(meanOf(column)));
    return table;
}

TextTable volumeTable(const OtfStudy& study) {
    TextTable table{{"reading", "tube cores with a surface", "Σd", "light from the surfaces %", "of x² %", "of eq. 1 %",
                     "mean light"},
                    {}};
    for (const ReadingResult& result : study.readings)
        table.rows.push_back({std::string(nameOf(result.reading)), std::to_string(result.tubesWithWeight),
                              fmt::format("{:.3f}", result.sumOfWeights), percent(result.light.meanShare),
                              percent(result.parabolaLight.meanShare), percent(result.linearLight.meanShare),
                              fmt::format("{:.3f}", result.light.meanIntensity)});
    return table;
}

std::string variantsCsv(const OtfStudy& study) {
    CsvTable csv({"interface_function", "parameter", "value", "reference", "front", "time_ratio", "time_ms",
                  "rms_difference", "max_difference", "right_weight_share", "empty_weight_share", "found_share",
                  "mean_error_units", "tubes_with_interface"});
    for (const VariantResult& result : study.variants) {
        // Without a truth these are unknown, not 0, so their cells are empty.
        const auto known = [&](double number) { return study.truthKnown ? number : NAN; };
        const DetectionQuality& detection = result.detection;
        csv.row({result.variant.interfaceFunction, result.variant.parameter, result.variant.value,
                 result.variant.isReference, result.onFront, result.timeRatio(), result.time(), result.rmsDifference(),
                 result.largestDifference, known(detection.rightShare()), known(detection.emptyShare()),
                 known(detection.foundShare()), known(detection.meanDistanceUnits()), detection.tubesWithInterface});
    }
    return csv.text();
}

std::string readingsCsv(const OtfStudy& study) {
    CsvTable csv({"reading", "group", "condition", "seed", "azimuth_degrees", "elevation_degrees", "right_weight_share",
                  "empty_weight_share", "found_share", "mean_error_units", "sum_of_d", "tubes_with_surface", "cnr_s",
                  "surface_light_share", "parabola_light_share", "linear_light_share", "message"});
    for (const ReadingResult& result : study.readings) {
        const auto known = [&](double number) { return study.truthKnown ? number : NAN; };
        csv.row({nameOf(result.reading), result.group, result.condition, result.seed, result.view.azimuthDegrees,
                 result.view.elevationDegrees, known(result.detection.rightShare()),
                 known(result.detection.emptyShare()), known(result.detection.foundShare()),
                 known(result.detection.meanDistanceUnits()), result.sumOfWeights, result.tubesWithWeight,
                 result.contrast, result.light.meanShare, result.parabolaLight.meanShare, result.linearLight.meanShare,
                 result.message});
    }
    return csv.text();
}

}  // namespace echolucent::cli
