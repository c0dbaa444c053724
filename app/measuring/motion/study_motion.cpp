// `study motion`: how the OTF changes while the probe or the object moves.
#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <memory>

#include "app/cli/options/option_text.h"
#include "app/cli/report/sweep_report.h"
#include "app/measuring/motion/motion_front.h"
#include "app/measuring/motion/motion_page.h"
#include "app/measuring/study.h"
#include "processing/phantom/phantom.h"

namespace echolucent::cli {

namespace {

constexpr int largestStillEdge = 64;  // pixels; larger ones would fill the page (HtmlPage::mostBytes)

/// Adds the motion of the probe, and, if there are several phases, those of the object and of both.
void addCases(std::vector<MotionCase>& cases, const MotionCase& base) {
    const auto with = [&](const char* name, const char* words, bool probe, bool object) {
        MotionCase added = base;
        added.name += std::string("_") + name;
        added.title += std::string(": ") + words;
        added.motion.probeMoves = probe;
        added.motion.objectMoves = object;
        added.stills = probe && !object;
        cases.push_back(std::move(added));
    };
    with("probe", "the probe moves", true, false);
    if (base.phases.size() < 2) return;
    with("object", "the object moves", false, true);
    with("both", "probe and object move", true, true);
}

std::string courseFile(const std::string& motionCase, MotionMode mode) {
    return fmt::format("otfs_{}_{}.csv", motionCase, nameOf(mode));
}

class MotionStudy final : public StudyCommand {
public:
    MotionStudy()
        : StudyCommand({"motion", "Flicker and lag of the OTF while the probe or the object moves",
                        "motion heart.nrrd --beam-axis +y --near 110 --phantoms -o motion"}) {}

private:
    void addOptions(CLI::App& command) override {
        addVolume(command);
        command.add_flag("--phantoms", m_onPhantoms,
                         "Also the simulated scans, beside VOLUME; alone where none is given");
        addFolder(command, "Folder for motion.html and the tables");
        command.add_option("--from", m_motion.from, "First angle, degrees")->type_name("DEG")->capture_default_str();
        command.add_option("--to", m_motion.to, "Last angle, degrees")->type_name("DEG")->capture_default_str();
        command.add_option("--step", m_motion.step, "Degrees a frame")->type_name("DEG")->capture_default_str();
        addCount(command, "--phantom-size", m_phantomSize, 32, 512, "Voxels along each edge of the simulated scans");
        addCount(command, "--phantom-phases", m_phantomPhases, 1, 100, "Phases of the simulated fetus' movement");
        addCount(command, "--picture-size", m_pictureSize, 16, 2048, "Pixels along each edge of the pictures compared");
        view.addTo(command);
        method.addTo(command);
    }

    /// The tables, the page, and two courses for every case of addCases().
    std::vector<std::string> files() const override {
        std::vector<std::string> names{"motion.csv", "motion_views.csv", "motion_front.csv", "motion.html"};
        for (const char* subject : {"shapes", "fetus", "volume"})
            for (const char* motion : {"probe", "object", "both"})
                for (const OtfSmoothing smoothing : {OtfSmoothing::none, OtfSmoothing::leastFlicker})
                    names.push_back(courseFile(fmt::format("{}_{}", subject, motion), smoothing));
        return names;
    }

    Result<void> check() override {
        constexpr double mostFrames = 2000;
        const double frames = 1.0 + std::abs(m_motion.to - m_motion.from) / m_motion.step;
        if (!(m_motion.step > 0.0) || !(frames >= 3.0 && frames <= mostFrames))
            return fail(FailureKind::wrongUsage, "", "--from, --to and --step", "must make 3 to 2000 frames");
        return {};
    }

    std::vector<std::shared_ptr<const Volume>> phantomPhases(PhantomScene scene) const {
        PhantomConfig scan = scaledPhantom(scene, m_phantomSize);
        const int phases = scene == PhantomScene::fetus ? m_phantomPhases : 1;
        std::vector<std::shared_ptr<const Volume>> volumes;
        for (int i = 0; i < phases; ++i) {
            scan.phase = static_cast<double>(i) / phases;
            volumes.push_back(std::make_shared<const Volume>(*makePhantom(scan)));
        }
        return volumes;
    }

    Result<std::vector<MotionCase>> cases() const {
        std::vector<MotionCase> all;
        if (m_onPhantoms || volume.path.empty()) {
            addCases(all, {"shapes", "Simulated shapes", phantomPhases(PhantomScene::shapes), {}, m_motion});
            addCases(all, {"fetus", "Simulated fetus", phantomPhases(PhantomScene::fetus), {}, m_motion});
        }
        if (volume.path.empty()) return all;
        const auto read = readPhases();
        if (!read) return tl::unexpected<Failure>(read.error());
        const auto from = viewOf(*read->phases[static_cast<std::size_t>(volume.phase)]);
        if (!from) return tl::unexpected<Failure>(from.error());
        MotionCase base{"volume", read->name, read->phases, *from, m_motion};
        base.motion.firstPhase = volume.phase;
        addCases(all, base);
        return all;
    }

    Result<StudyFindings> measure() override {
        const auto moved = cases();
        if (!moved) return tl::unexpected<Failure>(moved.error());
        std::vector<MotionFigures> figures;
        std::vector<FrontFigures> fronts;
        StudyFindings found;
        for (const MotionCase& one : *moved) {
            figures.push_back(measureMotion(one, config, m_pictureSize, std::min(largestStillEdge, m_pictureSize)));
            for (FrontFigures& front : measureFront(one, config)) fronts.push_back(std::move(front));
            for (const ModeFigures& mode : figures.back().modes) {
                if (mode.mode != OtfSmoothing::none && mode.mode != OtfSmoothing::leastFlicker) continue;
                std::vector<SweptOtf> course = figures.back().frames;
                for (std::size_t i = 0; i < course.size(); ++i) course[i].shown = mode.shown[i];
                found.files.emplace_back(courseFile(one.name, mode.mode), sweepTable(course));
            }
        }
        found.files.insert(found.files.end(), {{"motion.csv", motionFiguresTable(figures)},
                                               {"motion_views.csv", motionViewsTable(figures)},
                                               {"motion_front.csv", motionFrontTable(fronts)},
                                               {"motion.html", motionPage(figures)}});
        return found;
    }

    Motion m_motion{.axis = MotionAxis::screenVertical, .from = -45, .to = 45, .step = 1};
    bool m_onPhantoms = false;
    int m_phantomSize = 128, m_phantomPhases = 10, m_pictureSize = 160;
};

}  // namespace

std::shared_ptr<StudyCommand> motionStudy() { return std::make_shared<MotionStudy>(); }

}  // namespace echolucent::cli
