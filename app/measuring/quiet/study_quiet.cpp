// `study quiet`: the gain, the cost and the loss of each filter of speckle reduction.
#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <memory>

#include "app/measuring/quiet/quiet_measure.h"
#include "app/measuring/study.h"

namespace echolucent::cli {

namespace {

/// The results of one filter.
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

/// Means over the seeds, for every filter at once, so that phantom and rays are made only once.
void measureContrasts(const std::vector<PhantomConfig>& bases, PhantomScene scene, std::vector<QuietResult>& results) {
    for (std::size_t c = 0; c < conditionNames().size(); ++c) {
        std::vector<std::vector<std::optional<double>>> seeds(results.size());
        for (PhantomConfig base : bases) {
            base.scene = scene;
            const StudyPhantom phantom(contrastConditions(base)[c].config);
            const auto rays =
                trueSurfaces(phantom.volume.geometry(), phantom.truth, {},
                             scene == PhantomScene::shapes ? InterfaceInto::object : InterfaceInto::objectOrTissue);
            for (std::size_t f = 0; f < results.size(); ++f)
                seeds[f].push_back(quietContrastOf(phantom, rays, results[f].filter));
        }
        for (std::size_t f = 0; f < results.size(); ++f)
            (scene == PhantomScene::shapes ? results[f].shapes : results[f].fetus).push_back(meanOf(seeds[f]));
    }
}

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
            cells.insert(cells.end(), values->begin(), values->end());
        csv.row(cells);
    }
    return csv.text();
}

std::string pageOf(const std::vector<QuietResult>& results, const std::string& seeds) {
    HtmlPage page("Speckle reduction: what each filter brings and costs");
    page.paragraph(
        "Surfaces are a plane and a sphere with a radius of 12 units, both with a ramp of 4 units; they move by as "
        "many "
        "units as the middle of the mean profile does. Membrane (2 voxels of tissue in fluid) and finger (4 voxels of "
        "object in fluid): the share of their contrast that is left. Times are wall time in ms per million voxels of 8 "
        "bits, the median of several runs, without and with a data mask. CNR_S is that of the default curve, which is "
        "meant for the voxels that are shown, of the fetus on all its first surfaces; mean over the seeds " +
        seeds + " and six conditions.");
    addTable(page, filterTable(results));
    for (const bool ofShapes : {true, false}) {
        page.heading(ofShapes ? "CNR_S by condition, scene shapes" : "CNR_S by condition, scene fetus");
        addTable(page, contrastTable(results, ofShapes));
    }
    return page.text();
}

class QuietStudy final : public StudyCommand {
public:
    QuietStudy() : StudyCommand({"quiet", "What each filter of speckle reduction brings and costs", "quiet -o study"}) {
        phantoms.seeds = "11,12";
        folder = ".";
    }

private:
    void addOptions(CLI::App& command) override {
        phantoms.addTo(command);
        addCount(command, "--timed-edge", m_timedEdge, 8, 512, "Voxels an edge of the volume that is timed");
        addCount(command, "--repeats", m_repeats, 1, 1000, "Runs that are timed");
        addFolder(command, "Folder for the page and the table");
    }
    std::vector<std::string> files() const override { return {"quiet.html", "quiet.csv"}; }

    Result<StudyFindings> measure() override {
        std::vector<QuietResult> results;
        for (const QuietFilter& filter : quietFilters())
            results.push_back({filter,
                               structureErrorOf(filter, bases.front().seed),
                               quietTimesOf(filter, m_timedEdge, m_repeats),
                               {},
                               {}});
        for (const PhantomScene scene : {PhantomScene::shapes, PhantomScene::fetus})
            measureContrasts(bases, scene, results);
        return StudyFindings{{{"quiet.html", pageOf(results, phantoms.seeds)}, {"quiet.csv", csvOf(results)}},
                             plainText(filterTable(results)) + "\n" + plainText(contrastTable(results, true)) + "\n" +
                                 plainText(contrastTable(results, false))};
    }

    int m_timedEdge = 199, m_repeats = 5;
};

}  // namespace

std::shared_ptr<StudyCommand> quietStudy() { return std::make_shared<QuietStudy>(); }

}  // namespace echolucent::cli
