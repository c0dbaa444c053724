#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>

#include "app/cli/command.h"
#include "app/cli/options/look_options.h"
#include "app/cli/output_names.h"
#include "app/cli/report/picture_words.h"
#include "app/cli/report/sweep_report.h"
#include "io/output/atomic_file.h"
#include "io/study/import_report.h"
#include "io/writers/movie_file.h"
#include "processing/adaptive/adaptive_otf.h"

namespace echolucent::cli {

namespace {

struct SweepOptions {
    VolumeOptions volume;
    ViewOptions view;
    MethodOptions method;
    LookOptions look;
    std::string axis = "y", smoothing = "least-flicker", object = "still", probe = "moving", size = "512x512";
    double from = Motion{}.from, to = Motion{}.to, step = Motion{}.step, frameRate = 25;
    bool oneOtf = false, pictureFlicker = false;
    std::string csv, json, movie;
};

constexpr int largestFrameEdge = 4096;
constexpr double mostFrames = 100'000;

Result<Motion> motionFrom(const SweepOptions& options) {
    if (!isAngle(options.from) || !isAngle(options.to)) return wrongUsage("--from and --to", mustBeAngles);
    if (!(options.step > 0.0) || !std::isfinite(options.step)) return wrongUsage("--step", "must be above 0 degrees");
    if (std::abs(options.to - options.from) / options.step > mostFrames)
        return wrongUsage("--step", "makes more than 100000 frames", "Use a larger one.");
    Motion motion{
        .axis = *motionAxisFromName(options.axis), .from = options.from, .to = options.to, .step = options.step};
    motion.probeMoves = options.probe == "moving";
    motion.objectMoves = options.object == "moving";
    motion.firstPhase = options.volume.phase;
    if (!motion.probeMoves && !motion.objectMoves)
        return wrongUsage("--probe", "is still, and so is the object", "Use --object moving with a 4D volume.");
    return motion;
}

Result<RayCastSettings> frameSettingsFrom(const SweepOptions& options) {
    const auto size = parseWholePair(options.size, 1, largestFrameEdge, "--size", "512x512");
    if (!size) return tl::unexpected<Failure>(size.error());
    if (!(options.frameRate >= 1 && options.frameRate <= 1000))
        return wrongUsage("--frame-rate", "must be 1 to 1000 a second");
    const auto look = options.look.get();
    if (!look) return tl::unexpected<Failure>(look.error());
    RayCastSettings settings = rayCastSettings(*look);
    settings.width = (*size)[0];
    settings.height = (*size)[1];
    return settings;
}

/// The OTF of the view from which the probe turns, for all frames: what a person sees who computes no other.
std::vector<SweptOtf> withOneOtf(const Study& study, const Viewpoint& start, const std::vector<SweepFrame>& frames,
                                 const AdaptiveOtfConfig& config, int phase) {
    const auto otf = adaptOpacity(*study.phases[static_cast<std::size_t>(phase)], start, config);
    double sumOfD = 0.0;
    for (const TubeCore& tube : otf->tubes) sumOfD += tube.d;
    std::vector<SweptOtf> swept;
    swept.reserve(frames.size());
    for (const SweepFrame& frame : frames)
        swept.push_back({frame, otf->curve, otf->curve, sumOfD, otf->tubesWithWeight});
    return swept;
}

Result<void> writeMovie(const SweepOptions& options, const Study& study, const std::vector<SweptOtf>& swept,
                        const RayCastSettings& settings) {
    auto movie = MovieFile::begin(options.movie, settings.width, settings.height, options.frameRate);
    if (!movie) return tl::unexpected<Failure>(movie.error());
    const FrameRenderer render = frameRenderer(study.phases, framesOf(swept), settings);
    for (const SweptOtf& frame : swept) {
        std::vector<std::uint8_t> rgb = overBackground(*render(frame.frame, frame.shown), Vec3(0, 0, 0));
        writeWords(rgb, settings.width, settings.height, pictureWordsOf(study.phases.front()->geometry()));
        if (auto added = movie->add(rgb); !added) return added;
    }
    return movie->finish();
}

Result<void> writeReport(const SweepOptions& options, const Study& study, SweepReport& report,
                         const RayCastSettings& settings) {
    if (options.pictureFlicker) {
        const std::vector<SweepFrame> frames = framesOf(report.frames);
        const FrameRenderer render = frameRenderer(study.phases, frames, settings);
        report.unsmoothedPictures = pictureFlicker(frames, unsmoothedOf(report.frames), render);
        report.shownPictures = pictureFlicker(frames, shownOf(report.frames), render);
    }
    if (!options.csv.empty())
        if (auto done = writeFileAtomically(options.csv, sweepTable(report.frames)); !done) return done;
    if (!options.json.empty())
        if (auto done = writeFileAtomically(options.json, sweepJson(report)); !done) return done;
    if (options.csv.empty() && options.json.empty() && options.movie.empty())
        return writeFileAtomically("-", sweepSummary(report));
    return {};
}

void sayWhatIsMissing(const Study& study, const std::vector<SweptOtf>& swept, bool pictures) {
    const auto without =
        std::count_if(swept.begin(), swept.end(), [](const SweptOtf& frame) { return frame.tubesWithWeight == 0; });
    if (without > 0)
        std::fprintf(stderr, "No surface found in %d of %d frames: the initial function is used there.\n",
                     static_cast<int>(without), static_cast<int>(swept.size()));
    if (pictures) sayNote(burnedInTextNote(study));
    if (pictures) sayNote(pictureNotesOf(study.phases.front()->geometry(), "movie"));
}

std::vector<std::string> outputsOf(const SweepOptions& options) { return {options.csv, options.json, options.movie}; }

Result<void> checkSweepOutputs(const SweepOptions& options) {
    if ((options.json == "-") + (options.csv == "-") + (options.movie == "-") > 1)
        return wrongUsage("", "only one of --csv, --json and --movie can go to standard output");
    if (auto checked = checkMovieName(options.movie, "--movie"); !checked) return checked;
    return checkOutputs(outputsOf(options), {options.method.initial});
}

Result<void> sweep(const SweepOptions& options) {
    if (auto possible = checkSweepOutputs(options); !possible) return possible;
    const auto motion = motionFrom(options);
    if (!motion) return tl::unexpected<Failure>(motion.error());
    const auto settings = frameSettingsFrom(options);
    if (!settings) return tl::unexpected<Failure>(settings.error());
    if (!options.movie.empty())
        if (auto possible = MovieFile::check(options.movie, settings->width, settings->height); !possible)
            return possible;
    if (const auto checked = options.view.get(); !checked) return tl::unexpected<Failure>(checked.error());
    const auto config = options.method.get();
    if (!config) return tl::unexpected<Failure>(config.error());
    const auto study = options.volume.readAll(outputsOf(options));
    if (!study) return tl::unexpected<Failure>(study.error());
    if (motion->objectMoves && study->phases.size() < 2)
        return fail(FailureKind::wrongUsage, options.volume.path, "--object", "is moving, but the volume has one phase",
                    "Use --object still, or a 4D volume.");

    const auto view = options.view.get(*study->phases[static_cast<std::size_t>(motion->firstPhase)]);
    if (!view) return tl::unexpected<Failure>(view.error());
    const auto frames = motionFrames(*view, *motion, static_cast<int>(study->phases.size()));
    SweepReport report{.volume = options.volume.path, .start = *view, .motion = *motion};
    if (!options.oneOtf) report.smoothing = otfSmoothingFromName(options.smoothing);
    const std::vector<SweptOtf> swept = report.smoothing
                                            ? *sweepOtfs(study->phases, frames, *config, *report.smoothing)
                                            : withOneOtf(*study, *view, frames, *config, motion->firstPhase);
    report.frames = swept;
    sayWhatIsMissing(*study, swept, !options.movie.empty());
    if (auto done = writeReport(options, *study, report, *settings); !done) return done;
    return options.movie.empty() ? Result<void>() : writeMovie(options, *study, swept, *settings);
}

void addMotion(CLI::App& command, SweepOptions& options) {
    const auto movement = CLI::IsMember({"still", "moving"});
    command.add_option("--axis", options.axis, "Axis of the view about which the probe turns: x, y or z")
        ->check(CLI::IsMember({"x", "y", "z"}))
        ->capture_default_str();
    command.add_option("--from", options.from, "First angle from the given view, degrees")
        ->type_name("DEG")
        ->capture_default_str();
    command.add_option("--to", options.to, "Last angle, degrees")->type_name("DEG")->capture_default_str();
    command.add_option("--step", options.step, "Degrees a frame")->type_name("DEG")->capture_default_str();
    command.add_option("--probe", options.probe, "still (every frame from the given view) or moving")
        ->check(movement)
        ->capture_default_str();
    command
        .add_option("--object", options.object, "still, or moving: a 4D volume's phases, one a frame, over and over")
        ->check(movement)
        ->capture_default_str();
    auto* smoothing =
        command.add_option("--smoothing", options.smoothing, "none, mean, mls or least-flicker (docs/motion.md)")
            ->check(CLI::IsMember({"none", "mean", "mls", "least-flicker"}))
            ->capture_default_str();
    command.add_flag("--static", options.oneOtf, "One OTF, that of the given view, for all frames")
        ->excludes(smoothing);
}

void addOutputs(CLI::App& command, SweepOptions& options) {
    command.add_option("--csv", options.csv, "The OTFs as shown, one frame a row; - is standard output")
        ->type_name("FILE");
    command.add_option("--json", options.json, "Frames and flicker figures; - is standard output")->type_name("FILE");
    command.add_option("--movie", options.movie, "The rendered frames; the name ends in .avi, .mp4 or .mkv")
        ->type_name("FILE.mp4");
    command.add_flag("--picture-flicker", options.pictureFlicker,
                     "Also the flicker of the pictures, into the JSON: renders each frame up to six times");
    command.add_option("--size", options.size, "Pixels of the movie and of --picture-flicker")
        ->type_name("WxH")
        ->capture_default_str();
    command.add_option("--frame-rate", options.frameRate, "Frames a second of the movie")
        ->type_name("RATE")
        ->capture_default_str();
    options.look.addTo(command, {"lighting"});
}

}  // namespace

void addSweepCommand(CLI::App& program, Action& action) {
    auto options = std::make_shared<SweepOptions>();
    CLI::App& command = *program.add_subcommand("sweep", "The OTFs of a moving probe, a moving object, or both");
    options->volume.addTo(command);
    addMotion(command, *options);
    addOutputs(command, *options);
    options->view.addTo(command);
    options->method.addTo(command);
    command.footer(
        "Example: echolucent-cli sweep heart.nrrd --beam-axis +y --near 110 --object moving --movie heart.mp4");
    command.callback([options, &action] { action = [options] { return sweep(*options); }; });
}

}  // namespace echolucent::cli
