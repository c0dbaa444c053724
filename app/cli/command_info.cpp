#include <CLI/CLI.hpp>
#include <algorithm>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>
#include <span>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "app/cli/command.h"
#include "app/cli/options/option_text.h"
#include "app/cli/options/volume_options.h"
#include "app/cli/report/report_json.h"
#include "io/files/header_text.h"
#include "io/output/atomic_file.h"
#include "io/output/overwriting.h"
#include "io/study/import_report.h"
#include "io/study/series_list.h"
#include "processing/beam/beam_guess.h"
#include "processing/one_line.h"

namespace echolucent::cli {

namespace {

struct InfoOptions {
    VolumeOptions volume;
    bool toJson = false;
    std::string json;  ///< where the JSON goes; "-" is standard output
};

/// Smallest and largest value of the data voxels, the file's own; they mean nothing if dataVoxels is 0.
struct StoredRange {
    double low = 0.0;
    double high = 0.0;
    std::int64_t dataVoxels = 0;
};

/// Smallest and largest of the values at whose offset isData() holds. `dataVoxels` of the result counts all `values`:
/// the caller corrects it. The loop asks the volume nothing at a voxel, so that the compiler can vectorise it.
template <typename Value, typename IsData>
StoredRange rangeOfData(std::span<const Value> values, IsData isData) {
    Value low = std::numeric_limits<Value>::max(), high = std::numeric_limits<Value>::lowest();
    for (std::size_t offset = 0; offset < values.size(); ++offset) {
        const Value value = values[offset];
        low = std::min(low, isData(offset) ? value : low);
        high = std::max(high, isData(offset) ? value : high);
    }
    return {static_cast<double>(low), static_cast<double>(high), static_cast<std::int64_t>(values.size())};
}

StoredRange storedRangeOf(const Volume& volume) {
    StoredRange range = std::visit(
        [&](const auto& values) {
            const std::span all(values.data(), values.size());
            const std::uint8_t* const mask = volume.dataMaskOrNull();
            if (mask == nullptr) return rangeOfData(all, [](std::size_t) { return true; });
            const auto marked = [](std::uint8_t mark) { return mark != 0; };
            const auto count = std::count_if(mask, mask + values.size(), marked);
            if (count == 0) return StoredRange{};
            StoredRange ofData = rangeOfData(all, [&](std::size_t offset) { return marked(mask[offset]); });
            ofData.dataVoxels = count;
            return ofData;
        },
        volume.voxels());
    range.low = volume.valueScale().fileValue(range.low);
    range.high = volume.valueScale().fileValue(range.high);
    return range;
}

Json infoJson(const Study& study, const Volume& volume, int phase) {
    const VolumeGeometry& geometry = volume.geometry();
    const StoredRange range = storedRangeOf(volume);
    Json object;
    Json& entry = object["volume"];
    entry["name"] = study.name;
    entry["size"] = geometry.size;
    if (geometry.reduction) {
        entry["reduced_by"] = geometry.reduction->by;
        entry["stored_size"] = geometry.reduction->storedSize;
    }
    entry["spacing_mm"] = vectorJson(geometry.spacing);
    entry["spacing_known"] = geometry.spacingKnown;
    entry["origin_mm"] = vectorJson(geometry.origin);
    entry["direction"] = Json::array();
    for (int axis = 0; axis < 3; ++axis)
        entry["direction"].push_back(
            {geometry.direction(0, axis), geometry.direction(1, axis), geometry.direction(2, axis)});
    entry["patient_frame_known"] = geometry.patientFrameKnown;
    entry["type"] = volume.typeName();
    entry["black_level"] = volume.blackValue();
    entry["white_level"] = volume.whiteValue();
    entry["phases"] = study.phases.size();
    entry["phase"] = phase;
    entry["phase_seconds"] = study.phaseTimes.meanSeconds ? Json(*study.phaseTimes.meanSeconds) : Json();
    if (!study.phaseTimes.starts.empty()) entry["phase_times"] = study.phaseTimes.starts;
    entry["stored_range"] = range.dataVoxels > 0 ? Json{range.low, range.high} : Json();
    entry["no_data_share"] = 1.0 - static_cast<double>(range.dataVoxels) / static_cast<double>(geometry.voxelCount());
    const bool lossKnown = study.lossyCompression != LossyCompression::unknown;
    entry["lossy_compressed"] = lossKnown ? Json(study.lossyCompression == LossyCompression::yes) : Json();
    const BeamGuess guess = *guessBeamAxis(volume);
    object["view"] = {{"beam_axis", nameOf(guess.axis)}};
    object["beam"] = {{"axis", nameOf(guess.axis)},
                      {"source", guess.sure ? nameOf(guess.evidence) : "assumed"},
                      {"confidence", guess.confidence},
                      {"sentence", guess.sentence}};
    object["facts"] = Json::array();
    for (const ImportFact& fact : importReport(study, guess))
        object["facts"].push_back({{"name", fact.name}, {"value", fact.value}, {"source", fact.source}});
    object["warnings"] = study.warnings;
    return object;
}

/// Each line of the text without anything that controls a terminal: files may hold any text.
std::string printable(std::string_view text) {
    std::string lines;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        lines += oneLine(text.substr(0, end)) + '\n';
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return lines;
}

std::string infoText(const Study& study, const Volume& volume, int phase) {
    const StoredRange range = storedRangeOf(volume);
    std::string text = study.name + "\n";
    const auto line = [&](const std::string& name, const std::string& value, const std::string& source) {
        text += fmt::format("  {:<28} {}{}\n", name, value, source.empty() ? "" : "  [" + source + "]");
    };
    const BeamGuess guess = *guessBeamAxis(volume);
    for (const ImportFact& fact : importReport(study, guess)) line(fact.name, fact.value, fact.source);
    if (study.phases.size() > 1) line("phase shown below", std::to_string(phase), "--phase");
    line("stored values", range.dataVoxels > 0 ? fmt::format("{} to {}", range.low, range.high) : "none",
         "data voxels");
    for (const std::string& warning : study.warnings) text += "  Note: " + warning + "\n";
    return printable(text);
}

/// Why a series cannot be opened, and what to do: the failure's sentence without the file, since the list names it.
std::string reasonOf(const Failure& failure) {
    const std::string what = failure.element.empty() ? "it" : failure.element;
    return fmt::format("{} {}.{}{}", what, failure.problem, failure.remedy.empty() ? "" : " ", failure.remedy);
}

/// One line per series, numbered from 1. Below it stands what keeps it from being opened. The series `read` (may be
/// null) is marked.
std::string seriesText(const SeriesList& list, const SeriesEntry* read) {
    std::string text;
    for (std::size_t i = 0; i < list.series.size(); ++i) {
        const SeriesEntry& entry = list.series[i];
        const std::string name = fmt::format("series {}{}", i + 1, &entry == read ? ", read" : "");
        std::string value = entry.modality.empty() ? "" : entry.modality + ", ";
        value += sizeInWords(entry);
        if (!entry.distinction.empty()) value += ", " + entry.distinction;
        if (!entry.description.empty()) value += ", " + quotedText(entry.description);
        text += fmt::format("  {:<28} {}  [{}]\n", name, value, entry.uid);
        if (entry.whyNot) text += fmt::format("  {:<28} {}\n", "", reasonOf(*entry.whyNot));
    }
    return text;
}

/// One object per series (docs/cli-info.md).
Json seriesJson(const SeriesList& list, const SeriesEntry* read) {
    auto array = Json::array();
    for (const SeriesEntry& entry : list.series)
        array.push_back({{"number", array.size() + 1},
                         {"uid", entry.uid},
                         {"description", entry.description},
                         {"modality", entry.modality},
                         {"distinction", entry.distinction},
                         {"size", entry.size},
                         {"phases", entry.phases.count},
                         {"files", entry.files.size()},
                         {"read", &entry == read},
                         {"why_not", entry.whyNot ? Json(entry.whyNot->sentence()) : Json()}});
    return array;
}

/// What `info` does if the study could not be read: it writes the list of series, if there are at least two, and
/// returns `failure`. If the list cannot be written, it returns the failure of writing instead.
Result<void> writeListOnly(const std::optional<SeriesList>& list, const InfoOptions& options, const Failure& failure) {
    if (!list || list->series.size() < 2) return tl::unexpected(failure);
    const Json object{{"series", seriesJson(*list, nullptr)}};
    const std::string text = options.toJson ? object.dump(2, ' ', false, Json::error_handler_t::replace) + "\n"
                                            : printable(seriesText(*list, nullptr));
    const std::string output = options.toJson ? options.json : "-";
    if (auto written = writeFileAtomically(output, text); !written) return written;
    return tl::unexpected(failure);
}

Result<void> runInfo(const InfoOptions& options) {
    if (options.volume.path.empty()) return wrongUsage("VOLUME", "is required", "Name a volume.");
    keepFromOverwriting({options.volume.path});
    if (auto checked = checkOutputs({options.json}); !checked) return checked;
    const auto list = options.volume.listedSeries();
    if (!list) return tl::unexpected(list.error());
    const auto study = options.volume.readListed(*list, {options.json});
    if (!study) return writeListOnly(*list, options, study.error());
    const SeriesEntry* read = *list ? *options.volume.chosenSeries(**list) : nullptr;
    const Volume& volume = *study->phases[static_cast<std::size_t>(options.volume.phase)];
    if (!options.toJson) {
        std::string text = infoText(*study, volume, options.volume.phase);
        if (*list) text += printable(seriesText(**list, read));
        return writeFileAtomically("-", text);
    }
    Json object = infoJson(*study, volume, options.volume.phase);
    if (*list) object["series"] = seriesJson(**list, read);
    // Text in files may be in any encoding; JSON must be UTF-8.
    return writeFileAtomically(options.json, object.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

}  // namespace

void addInfoCommand(CLI::App& program, Action& action) {
    auto options = std::make_shared<InfoOptions>();
    CLI::App* command = program.add_subcommand("info", "Say what a volume file holds and how it was read");
    options->volume.addTo(*command);
    // runInfo() requires VOLUME. During parsing it may be empty: CLI11 takes the name in "--json NAME" for --json's
    // FILE.
    command->get_option("VOLUME")->required(false);
    CLI::Option* json = command
                            ->add_option("--json", options->json,
                                         "Write one JSON object (docs/cli-info.md) instead of text; - is standard "
                                         "output, also where no FILE is given")
                            ->type_name("FILE")
                            ->expected(0, 1);
    command->footer("Example:\n  echolucent-cli info heart.nrrd --phase 2 --json");
    command->callback([options, json, &action] {
        options->toJson = json->count() > 0;
        if (options->toJson && options->volume.path.empty()) std::swap(options->volume.path, options->json);
        if (options->json.empty()) options->json = "-";
        action = [options] { return runInfo(*options); };
    });
}

}  // namespace echolucent::cli
