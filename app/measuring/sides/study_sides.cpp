// `study sides`: the six sides of each volume, their fronts and scores, and which one comes first.
#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/cli/options/option_text.h"
#include "app/measuring/run_time.h"
#include "app/measuring/study.h"
#include "io/writers/picture_file.h"
#include "processing/beam/beam_guess.h"
#include "processing/beam/probe_view.h"
#include "processing/document/document.h"
#include "processing/document/side_taking.h"
#include "processing/pane_picture/pane_caster.h"
#include "processing/pane_picture/small_picture.h"
#include "processing/picture/picture.h"
#include "processing/scene/pose.h"
#include "processing/sides/side_search.h"

namespace echolucent::cli {

namespace {

constexpr const char* csvName = "sides.csv";

/// A scan with the view from its probe.
struct ProbedScan {
    std::string name;
    std::shared_ptr<const Volume> volume;
    Viewpoint fromProbe{};
    bool beamSure = true;
};

struct ListedPhantom {
    std::string_view name;
    PhantomScene scene;
    bool frontWall;
};
constexpr std::array listedPhantoms{ListedPhantom{"fetus", PhantomScene::fetus, false},
                                    ListedPhantom{"fetus behind a wall", PhantomScene::fetus, true},
                                    ListedPhantom{"shapes", PhantomScene::shapes, false},
                                    ListedPhantom{"shapes behind a wall", PhantomScene::shapes, true}};

/// The document that shows a side with its own front, and nothing else of its own.
Document documentOf(const ProbedScan& scan, const JudgedSide& judged) {
    Document document;
    document.beam.axis = judged.side.view.beamAxis;
    return withSideTaken(document, judged, scan.volume->dataBox(), 1.0);
}

/// The pictures of all sides, side by side.
std::string stripOf(const ProbedScan& scan, const SidesFinding& found, int edge) {
    PaneCaster caster(StudyPhases{.scans = {scan.volume}});
    const auto width = found.sides.size() * static_cast<std::size_t>(edge);
    std::vector<std::uint8_t> strip(3 * width * static_cast<std::size_t>(edge));
    for (std::size_t side = 0; side < found.sides.size(); ++side) {
        const auto picture = smallPicture(caster, documentOf(scan, found.sides[side]), firstPane, edge, edge);
        const std::vector<std::uint8_t> rgb = overBackground(*picture, {0, 0, 0});
        const auto row = 3 * static_cast<std::size_t>(edge);
        for (std::size_t y = 0; y < static_cast<std::size_t>(edge); ++y)
            std::copy_n(rgb.begin() + static_cast<std::ptrdiff_t>(y * row), row,
                        strip.begin() + static_cast<std::ptrdiff_t>(3 * width * y + side * row));
    }
    return pngBytes(static_cast<int>(width), edge, strip);
}

std::string rowOf(const JudgedSide& judged, bool best) {
    const SideScore& score = judged.score;
    return fmt::format(
        "{} {:<38}{:<19}{:>8}{:>7.2f}{:>6.0f} %{:>7.3f}{:>7.2f}{:>9.2f}{:>7.2f}{:>7.2f}{:>7.2f}{:>7.2f}{:>10.5f}{}\n",
        judged.side.number, judged.side.name, nameOf(judged.front.answer),
        makesFront(judged.front) ? fmt::format("{:.1f}{}", judged.front.nearCutMm, judged.front.surface ? "~" : "")
                                 : "-",
        judged.front.confidence, 100.0 * score.opened, score.area, score.depth, score.contrast, score.wholeness,
        score.shown, score.fineness.resolution, score.fineness.plane, score.total, best ? "  first" : "");
}

std::string tableOf(const ProbedScan& scan, const SidesFinding& found, double milliseconds) {
    std::string text =
        fmt::format("{}: beam {}{}, {:.0f} ms. {} {}\n", scan.name, nameOf(scan.fromProbe.beamAxis),
                    scan.beamSure ? "" : " (assumed)", milliseconds, found.planes.sentence, found.sentence);
    text += fmt::format("{:<40}{:<19}{:>8}{:>7}{:>8}{:>7}{:>7}{:>9}{:>7}{:>7}{:>7}{:>7}{:>10}\n", "side", "answer",
                        "front mm", "conf.", "opened", "area", "depth", "contrast", "whole", "shown", "resol.", "plane",
                        "score");
    for (std::size_t i = 0; i < found.sides.size(); ++i) text += rowOf(found.sides[i], i == found.best);
    return text + '\n';
}

class SidesStudy final : public StudyCommand {
public:
    SidesStudy()
        : StudyCommand({"sides", "The six sides of volumes: fronts, scores, and which one comes first",
                        "sides chest.mha heart.nrrd -o sides"}) {}

private:
    void addOptions(CLI::App& command) override {
        command.add_option("VOLUME", m_paths, "Files to read (of 4D, the first phase)");
        command.add_flag("--phantoms", m_phantoms, "Takes simulated scans too");
        command.add_option("-o,--output", folder, "Folder for pictures of the sides and sides.csv")->type_name("DIR");
        command
            .add_option("--beam-axis", view.beamAxis, "Grid axis of the beam, of all volumes: +x, -x, +y, -y, +z, -z")
            ->type_name("AXIS");
        command.add_flag("--bowed", m_bowed, "Takes bowed fronts where they fit better than flat ones");
        addCount(command, "--picture-size", m_edge, 16, 1024, "Pixels along each edge of a picture");
    }

    [[nodiscard]] Result<void> check() override {
        if (!m_paths.empty() || m_phantoms) return {};
        return wrongUsage("VOLUME", "is missing", "Name a file, or take --phantoms.");
    }

    [[nodiscard]] std::vector<std::string> files() const override {
        if (folder.empty()) return {};
        std::vector<std::string> names{csvName};
        const std::size_t scans = m_paths.size() + (m_phantoms ? listedPhantoms.size() : 0);
        for (std::size_t i = 0; i < scans; ++i) names.push_back(pictureName(i));
        return names;
    }

    /// A volume as it is opened: along --beam-axis, else from the probe of the file, else along a guess.
    [[nodiscard]] ProbedScan scanOf(const std::string& path, std::shared_ptr<const Volume> read) const {
        const ChosenBeam beam = view.beamOf(*read);
        const auto& probe = read->geometry().probe;
        const bool isStated = beam.source == nameOf(BeamEvidence::file) && probe;
        return {std::filesystem::path(path).filename().string(), std::move(read),
                isStated ? viewFromProbe(*probe) : Viewpoint{.beamAxis = beam.axis},
                beam.source != ChosenBeam{}.source};
    }

    [[nodiscard]] static std::string pictureName(std::size_t scan) { return fmt::format("sides-{}.png", scan + 1); }

    Result<StudyFindings> measure() override {
        StudyFindings findings;
        CsvTable csv({"scan", "side", "name", "answer", "front_mm", "confidence", "opened", "area", "depth", "contrast",
                      "wholeness", "shown", "resolution", "plane", "score", "exposure", "first"});
        std::size_t scans = 0;
        const CutShapes shapes = m_bowed ? CutShapes::flatAndCurved : CutShapes::flat;
        const auto add = [&](const ProbedScan& scan) {
            std::optional<SidesFinding> found;
            std::array<double, 3> times{};
            for (double& time : times)
                time = millisecondsOf([&] { found = findSides(*scan.volume, scan.fromProbe, scan.beamSure, shapes); });
            std::ranges::sort(times);
            findings.summary += tableOf(scan, *found, times[1]);
            for (std::size_t i = 0; i < found->sides.size(); ++i) {
                const auto& [side, front, score, exposure] = found->sides[i];
                csv.row({scan.name, side.number, side.name, nameOf(front.answer), front.nearCutMm, front.confidence,
                         score.opened, score.area, score.depth, score.contrast, score.wholeness, score.shown,
                         score.fineness.resolution, score.fineness.plane, score.total, exposure,
                         static_cast<int>(i == found->best)});
            }
            if (!folder.empty()) findings.files.emplace_back(pictureName(scans), stripOf(scan, *found, m_edge));
            ++scans;
        };
        for (const std::string& path : m_paths) {
            volume.path = path;
            const auto read = readVolume();
            if (!read) return tl::unexpected<Failure>(read.error());
            add(scanOf(path, *read));
        }
        if (m_phantoms)
            for (const ListedPhantom& one : listedPhantoms) {
                PhantomConfig simulated = defaultPhantom(one.scene);
                simulated.frontWall = one.frontWall;
                add({std::string(one.name), std::make_shared<const Volume>(*makePhantom(simulated))});
            }
        if (!folder.empty()) findings.files.emplace_back(csvName, csv.text());
        return findings;
    }

    std::vector<std::string> m_paths;
    bool m_phantoms = false, m_bowed = false;
    int m_edge = 256;
};

}  // namespace

std::shared_ptr<StudyCommand> sidesStudy() { return std::make_shared<SidesStudy>(); }

}  // namespace echolucent::cli
