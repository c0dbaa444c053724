// `study motion`: what the OTF does while the probe or the object moves.
#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <memory>

#include "app/cli/sweep_report.h"
#include "app/measuring/motion/motion_page.h"
#include "app/measuring/study.h"
#include "processing/phantom/phantom.h"

namespace echolucent::cli {

namespace {

struct MotionStudyOptions {
    VolumeOptions volume;
    ViewOptions view;
    MethodOptions method;
    bool phantoms = false;
    double from = -45, to = 45, step = 1;
    int phantomSize = 128, phantomPhases = 10, pictureSize = 160;
    std::string output;
};

constexpr int largestStillEdge = 64;  // pixels; larger ones would fill the page (HtmlPage::mostBytes)
/// The paper's volume is 99.5 mm wide.
constexpr double phantomExtentMm = 99.5;

/// Probe, object and both, as far as there are phases.
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

std::vector<std::shared_ptr<const Volume>> phantomPhases(PhantomScene scene, const MotionStudyOptions& options) {
    PhantomConfig config = defaultPhantom(scene);
    config.size.fill(options.phantomSize);
    config.spacing = Vec3::all(phantomExtentMm / options.phantomSize);
    const int phases = scene == PhantomScene::fetus ? options.phantomPhases : 1;
    std::vector<std::shared_ptr<const Volume>> volumes;
    for (int i = 0; i < phases; ++i) {
        config.phase = static_cast<double>(i) / phases;
        volumes.push_back(std::make_shared<const Volume>(*makePhantom(config)));
    }
    return volumes;
}

std::string courseFile(const std::string& motionCase, MotionMode mode) {
    return fmt::format("otfs_{}_{}.csv", motionCase, nameOf(mode));
}

/// All files that the study may write: the tables, the page, and for every case of addCases() two courses.
std::vector<std::string> namesOfFiles() {
    std::vector<std::string> names{"motion.csv", "motion_views.csv", "motion.html"};
    for (const char* subject : {"shapes", "fetus", "volume"})
        for (const char* motion : {"probe", "object", "both"})
            for (const OtfSmoothing smoothing : {OtfSmoothing::none, OtfSmoothing::leastFlicker})
                names.push_back(courseFile(fmt::format("{}_{}", subject, motion), smoothing));
    return names;
}

Result<std::vector<MotionCase>> casesFrom(const MotionStudyOptions& options, const std::vector<std::string>& outputs) {
    const Motion motion{.axis = MotionAxis::y, .from = options.from, .to = options.to, .step = options.step};
    std::vector<MotionCase> cases;
    if (options.phantoms || options.volume.path.empty()) {
        addCases(cases, {"shapes", "Simulated shapes", phantomPhases(PhantomScene::shapes, options), {}, motion});
        addCases(cases, {"fetus", "Simulated fetus", phantomPhases(PhantomScene::fetus, options), {}, motion});
    }
    if (options.volume.path.empty()) return cases;
    const auto study = options.volume.readAll(outputs);
    if (!study) return tl::unexpected<Failure>(study.error());
    const auto view = options.view.get(*study->phases[static_cast<std::size_t>(options.volume.phase)]);
    if (!view) return tl::unexpected<Failure>(view.error());
    MotionCase base{"volume", study->name, study->phases, *view, motion};
    base.motion.firstPhase = options.volume.phase;
    addCases(cases, base);
    return cases;
}

Result<void> check(const MotionStudyOptions& options) {
    constexpr double mostFrames = 2000;
    const double frames = std::abs(options.to - options.from) / options.step;
    if (!(options.step > 0.0) || !(frames >= 2.0 && frames <= mostFrames))
        return fail(FailureKind::wrongUsage, "", "--from, --to and --step", "must make 3 to 2000 frames");
    return {};
}

Result<void> studyMotion(const MotionStudyOptions& options) {
    if (auto checked = check(options); !checked) return checked;
    if (const auto checked = options.view.get(); !checked) return tl::unexpected<Failure>(checked.error());
    const auto config = options.method.get();
    if (!config) return tl::unexpected<Failure>(config.error());
    const auto folder = StudyFolder::at(options.output, namesOfFiles());
    if (!folder) return tl::unexpected<Failure>(folder.error());
    if (auto checked = checkOutputs(folder->paths(), {options.method.initial}); !checked) return checked;
    const auto cases = casesFrom(options, folder->paths());
    if (!cases) return tl::unexpected<Failure>(cases.error());

    std::vector<MotionFigures> figures;
    for (const MotionCase& motionCase : *cases) {
        figures.push_back(
            measureMotion(motionCase, *config, options.pictureSize, std::min(largestStillEdge, options.pictureSize)));
        for (const ModeFigures& mode : figures.back().modes) {
            if (mode.mode != OtfSmoothing::none && mode.mode != OtfSmoothing::leastFlicker) continue;
            std::vector<SweptOtf> course = figures.back().frames;
            for (std::size_t i = 0; i < course.size(); ++i) course[i].shown = mode.shown[i];
            const std::string name = courseFile(motionCase.name, mode.mode);
            if (auto done = folder->write(name, sweepTable(course)); !done) return done;
        }
    }
    if (auto done = folder->write("motion.csv", motionFiguresTable(figures)); !done) return done;
    if (auto done = folder->write("motion_views.csv", motionViewsTable(figures)); !done) return done;
    return folder->write("motion.html", motionPage(figures));
}

}  // namespace

void addStudyMotionCommand(CLI::App& study, Action& action) {
    auto options = std::make_shared<MotionStudyOptions>();
    CLI::App& command =
        *study.add_subcommand("motion", "Flicker and lag of the OTF while the probe or the object moves");
    options->volume.addTo(command);
    command.get_option("VOLUME")->required(false);
    command.add_flag("--phantoms", options->phantoms,
                     "Also the simulated scans, beside VOLUME; alone where none is given");
    command.add_option("-o,--output", options->output, "Folder for motion.html and the tables")
        ->type_name("DIR")
        ->required();
    command.add_option("--from", options->from, "First angle, degrees")->type_name("DEG")->capture_default_str();
    command.add_option("--to", options->to, "Last angle, degrees")->type_name("DEG")->capture_default_str();
    command.add_option("--step", options->step, "Degrees a frame")->type_name("DEG")->capture_default_str();
    command.add_option("--phantom-size", options->phantomSize, "Voxels along each edge of the simulated scans")
        ->check(CLI::Range(32, 512))
        ->capture_default_str();
    command.add_option("--phantom-phases", options->phantomPhases, "Phases of the simulated fetus' movement")
        ->check(CLI::Range(1, 100))
        ->capture_default_str();
    command.add_option("--picture-size", options->pictureSize, "Pixels along each edge of the pictures compared")
        ->check(CLI::Range(16, 2048))
        ->capture_default_str();
    options->view.addTo(command);
    options->method.addTo(command);
    command.footer("Example: echolucent-cli study motion heart.nrrd --beam-axis +y --near 110 --phantoms -o motion");
    command.callback([options, &action] { action = [options] { return studyMotion(*options); }; });
}

}  // namespace echolucent::cli
