// `study aim`: the aim from bright surfaces to every wall, against the truth of simulated scans.
#include "app/measuring/aim/study_aim.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "app/measuring/designers/study_designers.h"
#include "app/measuring/study.h"
#include "processing/choice_names.h"
#include "processing/designers/adaptive_design.h"
#include "processing/phantom/phantom.h"

namespace echolucent::cli {

namespace {

using Percent = std::optional<double>;

/// "aim 0, objects: 98.1 of 99.4 %, 0.987 of the best ramp's; at least 0.954, in hard_ramp8."
std::string againstBound(const std::vector<NamedSurfaces>& rows, double aim, SurfaceKind kind, const char* bound) {
    std::vector<Percent> own, best;
    double least = std::numeric_limits<double>::infinity();
    std::string leastIn;
    for (const std::string& condition : conditionsOf(rows)) {
        const Percent is = meanPercent(rows, nameOfAim(aim), condition, kind, ShownSurface::right),
                      could = meanPercent(rows, bound, condition, kind, ShownSurface::right);
        if (!is || !could || !(*could > 0.0)) continue;
        own.push_back(is);
        best.push_back(could);
        if (*is / *could < least) {
            least = *is / *could;
            leastIn = condition;
        }
    }
    if (own.empty()) return {};
    const double mean = *meanOf(own), bestMean = *meanOf(best);
    return fmt::format("{}, {}: right {:.1f} of {:.1f} %, {:.3f} of the {}; at least {:.3f}, in {}.\n", nameOfAim(aim),
                       nameOf(kind), mean, bestMean, mean / bestMean, bound, least, leastIn);
}

/// How far truth and tube cores agree on OTFs that somebody could choose: not on the best ramps, which the truth chose.
std::string rankSentences(const std::vector<NamedSurfaces>& rows) {
    std::vector<NamedSurfaces> otfs, designers;
    for (const NamedSurfaces& row : rows) {
        if (row.name == boundOfObjects || row.name == boundOfAll) continue;
        const bool aim = row.name.starts_with("aim ");
        // The default is one of the aims, and counts once.
        if (aim || row.name != nameOf(designerOf(AdaptiveConfig{}))) otfs.push_back(row);
        if (!aim) designers.push_back(row);
    }
    return rankSentence(otfs) + "\nOf the designers and x² alone: " + rankSentence(designers) + "\n";
}

std::string summaryOf(const std::vector<NamedSurfaces>& rows) {
    return plainText(shownSurfaceTable(rows)) + plainText(rightTable(rows, SurfaceKind::all)) +
           plainText(rightTable(rows, SurfaceKind::tubeCores)) +
           againstBound(rows, 0.0, SurfaceKind::objects, boundOfObjects) +
           againstBound(rows, 1.0, SurfaceKind::all, boundOfAll) + rankSentences(rows);
}

class AimStudy final : public StudyCommand {
public:
    AimStudy()
        : StudyCommand({"aim", "What the aim of the adaptive curve shows of true surfaces, beside all designers",
                        "aim --seeds 1,2 -o aim"}) {}

private:
    void addOptions(CLI::App& command) override {
        phantoms.addTo(command);
        addFolder(command, "Folder for aim.csv and aim.txt");
        const auto add = [&](const char* name, std::vector<std::string>& values, const char* meaning,
                             const std::vector<std::string>& known) {
            command.add_option(name, values, meaning)
                ->delimiter(',')
                ->check(CLI::IsMember(known))
                ->type_name("LIST")
                ->capture_default_str();
        };
        add("--scenes", m_scenes, "Simulated scenes", {"shapes", "fetus"});
        add("--views", m_views, "Views: along the beam, and 20 and -12 degrees off it", {"beam", "oblique"});
        add("--reductions", m_reductions, "Speckle reductions", {"off", "light", "medium", "strong"});
    }
    std::vector<std::string> files() const override { return {"aim.csv", "aim.txt"}; }

    Result<StudyFindings> measure() override {
        std::vector<AimRow> rows;
        for (const std::string& scene : m_scenes)
            for (const std::string& direction : m_views)
                for (const std::string& reduction : m_reductions)
                    for (const PhantomConfig& base : bases) {
                        const AimCase one{phantomSceneFromName(scene).value(), direction == "oblique",
                                          choiceNamed<SpeckleReduction>(speckleReductionNames, reduction).value()};
                        for (AimRow& row : measureAims(base, one)) rows.push_back(std::move(row));
                    }
        const std::string summary = aimSummary(rows);
        return StudyFindings{{{"aim.csv", aimCsv(rows)}, {"aim.txt", summary}}, summary};
    }

    std::vector<std::string> m_scenes{"shapes", "fetus"}, m_views{"beam", "oblique"},
        m_reductions{"medium", "off", "strong"};
};

}  // namespace

std::string nameOf(const AimCase& one) {
    return fmt::format("{}, {}, reduction {}", nameOf(one.scene), one.oblique ? "oblique" : "along the beam",
                       nameOf(one.reduction));
}

std::string aimSummary(const std::vector<AimRow>& rows) {
    std::string text;
    for (const std::string& name : namesIn(rows, [](const AimRow& row) { return nameOf(row.of); })) {
        std::vector<NamedSurfaces> own;
        for (const AimRow& row : rows)
            if (nameOf(row.of) == name) own.push_back(row.named);
        text += name + "\n" + summaryOf(own) + "\n";
    }
    std::vector<NamedSurfaces> all;
    for (const AimRow& row : rows) {
        all.push_back(row.named);
        all.back().condition += ", " + nameOf(row.of);
    }
    return text + "All scans: " + rankSentences(all);
}

std::string aimCsv(const std::vector<AimRow>& rows) {
    std::vector<std::string> columns{"scene", "view", "reduction", "condition", "seed", "otf"};
    const auto surfaces = shownSurfaceColumns();
    columns.insert(columns.end(), surfaces.begin(), surfaces.end());
    CsvTable csv(columns);
    for (const AimRow& row : rows) {
        std::vector<CsvCell> cells{nameOf(row.of.scene),
                                   row.of.oblique ? "oblique" : "beam",
                                   nameOf(row.of.reduction),
                                   row.named.condition,
                                   row.seed,
                                   row.named.name};
        for (CsvCell& cell : shownSurfaceCells(row.named.surfaces)) cells.push_back(std::move(cell));
        csv.row(cells);
    }
    return csv.text();
}

std::shared_ptr<StudyCommand> aimStudy() { return std::make_shared<AimStudy>(); }

}  // namespace echolucent::cli
