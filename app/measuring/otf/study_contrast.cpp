// `study contrast`: CNR_S and shown depth of the fixed curves and of the readings, condition by condition.
#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <memory>

#include "app/cli/options/look_options.h"
#include "app/measuring/shown_surfaces.h"
#include "app/measuring/study.h"
#include "io/output/atomic_file.h"

namespace echolucent::cli {

namespace {

using Values = std::vector<std::optional<double>>;

std::string line(const std::string& name, const Values& values) {
    std::string text = fmt::format("{:<22}", name);
    for (const auto& value : values) text += value ? fmt::format("{:>11.2f}", *value) : fmt::format("{:>11}", "-");
    return text + '\n';
}

/// The mean over the rows for every column.
Values columnMeans(const std::vector<Values>& rows) {
    Values means;
    for (std::size_t c = 0; c < rows.front().size(); ++c) {
        Values column;
        for (const Values& row : rows) column.push_back(row[c]);
        means.push_back(meanOf(column));
    }
    return means;
}

/// What each curve of contrastCurvesOf() makes of the surfaces, on voxels made quiet by `reduction`.
std::vector<ShownSurfaces> surfacesOf(const StudyPhantom& phantom, const Viewpoint& view, SpeckleReduction reduction) {
    const bool off = reduction == SpeckleReduction::off;
    const Volume quiet = *quietVolume(phantom.volume, reduction);
    const auto curves = contrastCurvesOf(phantom.volume, view, {off ? nullptr : &quiet, reduction});
    return shownSurfacesOf(phantom.volume, quiet, view, &phantom.truth, curves);
}

class ContrastStudy final : public StudyCommand {
public:
    ContrastStudy()
        : StudyCommand(
              {"contrast", "How well the curves show known surfaces: shown depth and CNR_S", "contrast --seeds 1-4"}) {}

private:
    void addOptions(CLI::App& command) override {
        phantoms.addTo(command);
        view.addTo(command, ViewOf::simulatedScan);
        m_look.addTo(command, {"reduction"});
        command.add_option("--csv", m_csv, "Also writes every value")->type_name("FILE");
    }

    Result<StudyFindings> measure() override {
        const auto from = view.getOfSimulatedScan();
        if (!from) return tl::unexpected<Failure>(from.error());
        const auto look = m_look.get();
        if (!look) return tl::unexpected<Failure>(look.error());
        const std::vector<std::string> names = contrastCurveNames();
        std::string text = fmt::format("CNR_S, mean of {} seed(s), speckle reduction {}\n{:<22}", bases.size(),
                                       nameOf(look->reduction), "condition");
        for (const std::string& name : names) text += fmt::format("{:>{}}", name, 11);
        text += '\n';
        std::vector<std::string> columns{"condition", "seed", "curve"};
        for (std::string& column : shownSurfaceColumns()) columns.push_back(std::move(column));
        columns.emplace_back("cnr_s");
        CsvTable csv(columns);
        std::vector<NamedSurfaces> shown;
        std::vector<Values> conditions;
        const std::size_t count = contrastConditions(bases.front()).size();
        for (std::size_t c = 0; c < count; ++c) {
            std::vector<Values> seeds;
            std::string name;
            for (const PhantomConfig& base : bases) {
                const NamedPhantom phantom = contrastConditions(base)[c];
                name = phantom.name;
                const auto surfaces = surfacesOf(StudyPhantom(phantom.config), *from, look->reduction);
                seeds.emplace_back();
                for (std::size_t i = 0; i < names.size(); ++i) {
                    seeds.back().push_back(surfaces[i].truth->contrast);
                    shown.push_back({names[i], name, surfaces[i]});
                    std::vector<CsvCell> cells{name, base.seed, names[i]};
                    for (CsvCell& cell : shownSurfaceCells(surfaces[i])) cells.push_back(std::move(cell));
                    cells.emplace_back(seeds.back()[i]);
                    csv.row(cells);
                }
            }
            conditions.push_back(columnMeans(seeds));
            text += line(name, conditions.back());
        }
        text += line("mean", columnMeans(conditions));
        text += "\n" + plainText(rightTable(shown, SurfaceKind::all)) + "\n" +
                plainText(rightTable(shown, SurfaceKind::tubeCores)) + "\n" + plainText(shownSurfaceTable(shown)) +
                "\n" + rankSentence(shown) + "\n";
        if (!m_csv.empty())
            if (auto written = writeFileAtomically(m_csv, csv.text()); !written)
                return tl::unexpected<Failure>(written.error());
        return StudyFindings{{}, text};
    }

    LookOptions m_look;
    std::string m_csv;
};

}  // namespace

std::shared_ptr<StudyCommand> contrastStudy() { return std::make_shared<ContrastStudy>(); }

}  // namespace echolucent::cli
