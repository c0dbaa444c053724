// `study quiet`: what each filter of speckle reduction brings, costs and takes away.
#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <memory>

#include "app/measuring/otf/study_otf.h"
#include "app/measuring/quiet/quiet_measure.h"
#include "app/measuring/study.h"
#include "app/pages/html_page.h"
#include "io/output/atomic_file.h"

namespace echolucent::cli {

namespace {

struct QuietStudyOptions {
    PhantomChoice phantoms{.seeds = "11,12", .size = {}};
    std::string folder = ".";
    int timedEdge = 199, repeats = 5;
};

/// What is known of one filter.
struct QuietResult {
    QuietFilter filter;
    StructureError error;
    QuietTimes times;
    /// CNR_S by scene and condition, mean over the seeds: the six conditions of shapes, then of fetus.
    std::vector<std::optional<double>> shapes, fetus;
};

const std::vector<std::string>& conditionNames() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> all;
        for (const NamedPhantom& one : contrastConditions({})) all.push_back(one.name);
        return all;
    }();
    return names;
}

/// Means over the seeds, for every filter at once: phantom and rays are made once.
void measureContrasts(const std::vector<PhantomConfig>& bases, PhantomScene scene, std::vector<QuietResult>& results) {
    for (std::size_t c = 0; c < conditionNames().size(); ++c) {
        std::vector<std::vector<std::optional<double>>> seeds(results.size());
        for (PhantomConfig base : bases) {
            base.scene = scene;
            const StudyPhantom phantom(contrastConditions(base)[c].config);
            const auto rays =
                objectRays(phantom.volume.geometry(), phantom.truth, {},
                           scene == PhantomScene::shapes ? InterfaceInto::object : InterfaceInto::objectOrTissue);
            for (std::size_t f = 0; f < results.size(); ++f)
                seeds[f].push_back(quietContrastOf(phantom, rays, results[f].filter));
        }
        for (std::size_t f = 0; f < results.size(); ++f)
            (scene == PhantomScene::shapes ? results[f].shapes : results[f].fetus).push_back(meanOf(seeds[f]));
    }
}

std::string shown(const std::optional<double>& value) { return value ? fmt::format("{:.2f}", *value) : "-"; }

TextTable filterTable(const std::vector<QuietResult>& results) {
    TextTable table{{"filter", "reduction", "plane moves", "sphere moves", "membrane left", "finger left",
                     "CNR_S shapes", "CNR_S fetus", "ms/M voxels", "with mask"},
                    {}};
    for (const QuietResult& result : results)
        table.rows.push_back({result.filter.name, result.filter.setting, fmt::format("{:.2f}", result.error.planeShift),
                              fmt::format("{:+.2f}", result.error.sphereShift),
                              fmt::format("{:.0f} %", 100.0 * result.error.membrane),
                              fmt::format("{:.0f} %", 100.0 * result.error.finger), shown(meanOf(result.shapes)),
                              shown(meanOf(result.fetus)), fmt::format("{:.1f}", result.times.whole),
                              fmt::format("{:.1f}", result.times.masked)});
    return table;
}

TextTable contrastTable(const std::vector<QuietResult>& results, bool ofShapes) {
    TextTable table{{"filter"}, {}};
    table.columns.insert(table.columns.end(), conditionNames().begin(), conditionNames().end());
    for (const QuietResult& result : results) {
        std::vector<std::string> row{result.filter.name};
        for (const auto& value : ofShapes ? result.shapes : result.fetus) row.push_back(shown(value));
        table.rows.push_back(std::move(row));
    }
    return table;
}

std::string csvOf(const std::vector<QuietResult>& results) {
    std::vector<std::string> columns{"filter",   "reduction", "plane_shift",           "sphere_shift",
                                     "membrane", "finger",    "ms_per_million_voxels", "ms_per_million_voxels_masked"};
    for (const char* scene : {"shapes ", "fetus "})
        for (const std::string& name : conditionNames()) columns.push_back(scene + name);
    CsvTable csv(columns);
    for (const QuietResult& result : results) {
        std::vector<CsvCell> cells{result.filter.name,       result.filter.setting, result.error.planeShift,
                                   result.error.sphereShift, result.error.membrane, result.error.finger,
                                   result.times.whole,       result.times.masked};
        for (const auto* values : {&result.shapes, &result.fetus})
            for (const auto& value : *values) cells.emplace_back(value.value_or(NAN));
        csv.row(cells);
    }
    return csv.text();
}

std::string pageOf(const std::vector<QuietResult>& results, const QuietStudyOptions& options) {
    HtmlPage page("Speckle reduction: what each filter brings and costs");
    page.paragraph(
        "Surfaces are a plane and a sphere with a radius of 12 units, both with a ramp of 4 units; they move by as "
        "many "
        "units as the middle of the mean profile does. Membrane (2 voxels of tissue in fluid) and finger (4 voxels of "
        "object in fluid): the share of their contrast that is left. Times are wall time in ms per million voxels of 8 "
        "bits, the median of several runs, without and with a data mask. CNR_S is that of the default curve, which is "
        "meant for the voxels that are shown, of the fetus on all its first surfaces; mean over the seeds " +
        options.phantoms.seeds + " and six conditions.");
    const TextTable filters = filterTable(results);
    page.table(filters.columns, filters.rows);
    for (const bool ofShapes : {true, false}) {
        page.heading(ofShapes ? "CNR_S by condition, scene shapes" : "CNR_S by condition, scene fetus");
        const TextTable table = contrastTable(results, ofShapes);
        page.table(table.columns, table.rows);
    }
    return page.text();
}

Result<void> studyQuiet(const QuietStudyOptions& options) {
    const auto bases = options.phantoms.bases();
    if (!bases) return tl::unexpected<Failure>(bases.error());
    const auto folder = StudyFolder::at(options.folder, {"quiet.html", "quiet.csv"});
    if (!folder) return tl::unexpected<Failure>(folder.error());
    std::vector<QuietResult> results;
    for (const QuietFilter& filter : quietFilters())
        results.push_back({filter,
                           structureErrorOf(filter, bases->front().seed),
                           quietTimesOf(filter, options.timedEdge, options.repeats),
                           {},
                           {}});
    for (const PhantomScene scene : {PhantomScene::shapes, PhantomScene::fetus})
        measureContrasts(*bases, scene, results);
    if (auto done = folder->write("quiet.html", pageOf(results, options)); !done) return done;
    if (auto done = folder->write("quiet.csv", csvOf(results)); !done) return done;
    return writeFileAtomically("-", plainText(filterTable(results)) + "\n" + plainText(contrastTable(results, true)) +
                                        "\n" + plainText(contrastTable(results, false)));
}

}  // namespace

void addStudyQuietCommand(CLI::App& study, Action& action) {
    auto options = std::make_shared<QuietStudyOptions>();
    CLI::App& command = *study.add_subcommand("quiet", "What each filter of speckle reduction brings and costs");
    options->phantoms.addTo(command);
    command.add_option("--timed-edge", options->timedEdge, "Voxels an edge of the volume that is timed")
        ->check(CLI::Range(8, 512))
        ->capture_default_str();
    command.add_option("--repeats", options->repeats, "Runs that are timed")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    command.add_option("-o,--output", options->folder, "Folder for the page and the table")
        ->type_name("DIR")
        ->capture_default_str();
    command.footer("Example: echolucent-cli study quiet -o study");
    command.callback([options, &action] { action = [options] { return studyQuiet(*options); }; });
}

}  // namespace echolucent::cli
