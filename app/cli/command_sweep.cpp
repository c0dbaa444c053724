#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <memory>
#include <numeric>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "app/cli/command.h"
#include "app/cli/options/document_study.h"
#include "app/cli/options/look_options.h"
#include "app/cli/options/method_options.h"
#include "app/cli/options/option_text.h"
#include "app/cli/options/view_options.h"
#include "app/cli/options/volume_options.h"
#include "app/cli/output_names.h"
#include "app/cli/report/opening_report.h"
#include "app/cli/report/picture_words.h"
#include "app/cli/report/sweep_report.h"
#include "app/cli/sweep_frames.h"
#include "io/output/atomic_file.h"
#include "io/study/import_report.h"
#include "io/writers/looped_pictures.h"
#include "io/writers/movie_file.h"
#include "processing/motion/flicker.h"
#include "processing/motion/movie_length.h"
#include "processing/motion/otf_sweep.h"

namespace echolucent::cli {

namespace {

struct SweepOptions {
    VolumeOptions volume;
    DocumentOptions document;
    ViewOptions view;
    MethodOptions method;
    LookOptions look;
    std::string axis, smoothing, object, probe, size = "512x512";
    std::optional<double> from, to, step, frameRate, seconds;
    std::optional<int> loops;
    bool oneOtf = false, pictureFlicker = false, words = false;
    std::string csv, json, movie;

    [[nodiscard]] bool angles() const { return from || to || step; }
};

constexpr int largestFrameEdge = 4096;
constexpr double mostFrames = 100'000;
constexpr double leastFrameRate = 1.0, largestFrameRate = 1000.0;
constexpr int mostLoops = 1000;
constexpr double mostSeconds = 3600.0;

Result<std::array<int, 2>> frameSizeFrom(const SweepOptions& options) {
    if (options.frameRate && !(*options.frameRate >= leastFrameRate && *options.frameRate <= largestFrameRate))
        return wrongUsage("--frame-rate", "must be 1 to 1000 a second");
    return parseWholePair(options.size, 1, largestFrameEdge, "--size", "512x512");
}

/// How long the movie is; one loop of the frames if nobody says.
Result<MovieLength> lengthFrom(const SweepOptions& options) {
    if (options.loops && (*options.loops < 1 || *options.loops > mostLoops))
        return wrongUsage("--loops", "must be 1 to 1000");
    if (options.seconds && !(*options.seconds > 0.0 && *options.seconds <= mostSeconds))
        return wrongUsage("--seconds", "must be above 0, at most 3600");
    if (options.seconds) return MovieLength{MovieLengthUnit::seconds, *options.seconds};
    return MovieLength{MovieLengthUnit::loops, static_cast<double>(options.loops.value_or(1))};
}

/// The range of angles. framesFrom() adds what moves. Fails (wrong usage) if an angle or the step is out of range, or
/// if there are too many frames.
Result<Motion> rangeFrom(const SweepOptions& options) {
    Motion range;
    range.from = options.from.value_or(range.from);
    range.to = options.to.value_or(range.to);
    range.step = options.step.value_or(range.step);
    if (!isAngle(range.from) || !isAngle(range.to)) return wrongUsage("--from and --to", mustBeAngles);
    if (!(range.step > 0.0) || !std::isfinite(range.step)) return wrongUsage("--step", "must be above 0 degrees");
    if (std::abs(range.to - range.from) / range.step > mostFrames)
        return wrongUsage("--step", "makes more than 100000 frames", "Use a larger one.");
    return range;
}

/// The motion of the document `opened`, as the options edit it. Fails (wrong usage) if neither probe nor object moves,
/// if the object is to move and has one phase, or if --axis is given for a probe that is still.
Result<MotionChoice> motionFrom(const SweepOptions& options, const Document& opened, std::size_t phases) {
    MotionChoice motion = opened.motion;
    const bool turned = options.angles() || !options.axis.empty() || movesProbe(motion.scenario);
    const bool probe = options.probe.empty() ? turned : options.probe == "moving";
    const bool object = options.object.empty() ? movesObject(motion.scenario) : options.object == "moving";
    if (!probe && !object)
        return wrongUsage("--probe", "is still, and so is the object", "Use --object moving with a 4D volume.");
    if (object && phases < 2)
        return fail(FailureKind::wrongUsage, options.volume.path, "--object", "is moving, but the volume has one phase",
                    "Use --object still, or a 4D volume.");
    if (!probe && !options.axis.empty())
        return wrongUsage("--axis", "plays no part beside --probe still", "Leave it out, or use --probe moving.");
    motion.axis = motionAxisFromName(options.axis).value_or(motion.axis);
    motion.scenario = probe && object ? MotionScenario::both : probe ? MotionScenario::probe : MotionScenario::object;
    return motion;
}

/// The frames of the range of angles. If no angle is given, they are one turn of the document's motion. The motion
/// repeats: the turn's last `before` frames count as shown before its first.
Frames framesFrom(const SweepOptions& options, Motion range, const DocumentStudy& made, std::size_t before) {
    if (!options.angles()) return turnFrames(made, before);
    const Document& document = made.document;
    range.axis = document.motion.axis;
    range.probeMoves = movesProbe(document.motion.scenario);
    range.objectMoves = movesObject(document.motion.scenario);
    range.firstPhase = phaseOf(document, made.pane);
    return {motionFrames(motionStartOf(document), range, static_cast<int>(made.study.phases.size()))};
}

/// The pictures of a movie.
struct MoviePictures {
    double rate = 0.0;          ///< pictures a second
    std::vector<int> frames{};  ///< that each picture shows, counted from 0
};

/// Fails (wrong usage) if there are too many pictures.
Result<MoviePictures> picturesFrom(const SweepOptions& options, const DocumentStudy& made, const Frames& frames) {
    std::vector<int> phases;
    for (const SweepFrame& frame : frames.frames) phases.push_back(frame.phase);
    const HeldFrames held = heldFrames(made.document.motion, made.study.phaseTimes, phases, 1.0 / largestFrameRate);
    const double rate =
        options.frameRate.value_or(std::clamp(1.0 / held.pictureSeconds, leastFrameRate, largestFrameRate));
    const MovieLength length = *lengthFrom(options);
    const double pictures = length.unit == MovieLengthUnit::seconds
                                ? length.amount * rate
                                : length.amount * std::accumulate(held.pictures.begin(), held.pictures.end(), 0.0);
    if (pictures > mostFrames)
        return wrongUsage("--loops and --seconds", "make more than 100000 pictures", "Make the movie shorter.");
    return MoviePictures{rate, framesOfPictures(held.pictures, length, rate)};
}

Result<void> writeMovie(const SweepOptions& options, const DocumentStudy& made, const std::vector<SweptOtf>& swept,
                        const MoviePictures& pictures, FrameCaster& caster, const std::array<int, 2>& size) {
    auto movie = MovieFile::begin(options.movie, size[0], size[1], pictures.rate);
    if (!movie) return tl::unexpected<Failure>(movie.error());
    const std::string words = options.words ? pictureWordsOf(made.study.phases.front()->geometry()) : "";
    const auto make = [&](int number) -> Result<MoviePicture> {
        const SweptOtf& frame = swept[static_cast<std::size_t>(number)];
        MoviePicture rgb = overBackground(caster.picture(frame.frame, frame.shown, size), Vec3(0, 0, 0));
        writeWords(rgb, size[0], size[1], words);
        return rgb;
    };
    const auto added =
        addLooped(pictures.frames, make, [&](std::span<const std::uint8_t> rgb) { return movie->add(rgb); });
    return added ? movie->finish() : added;
}

Result<void> writeReport(const SweepOptions& options, SweepReport& report, FrameCaster& caster,
                         const std::array<int, 2>& size) {
    if (options.pictureFlicker) {
        const std::vector<SweepFrame> frames = framesOf(report.frames);
        const FrameRenderer render = [&](const SweepFrame& frame, const SampledCurve& curve) {
            return std::optional(caster.picture(frame, curve, size));
        };
        report.unsmoothedPictures = pictureFlicker(frames, unsmoothedOf(report.frames), render);
        report.shownPictures =
            report.smoothing ? pictureFlicker(frames, shownOf(report.frames), render) : report.unsmoothedPictures;
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

Result<void> checkSweepOutputs(const SweepOptions& options, const std::array<int, 2>& size) {
    if (std::ranges::count(outputsOf(options), "-") > 1)
        return wrongUsage("", "only one of --csv, --json and --movie can go to standard output");
    if (auto checked = checkMovieName(options.movie, "--movie"); !checked) return checked;
    if (auto checked = checkOutputs(outputsOf(options), {options.method.initial}); !checked) return checked;
    return options.movie.empty() ? Result<void>() : MovieFile::check(options.movie, size[0], size[1]);
}

/// The study of VOLUME, opened, and its document as the options edit it.
Result<DocumentStudy> openedForSweep(const SweepOptions& options, double aspect) {
    const auto config = options.method.get();
    if (!config) return tl::unexpected<Failure>(config.error());
    const auto look = options.look.get();
    if (!look) return tl::unexpected<Failure>(look.error());
    auto opened = openStudy(options.volume, options.view, *look, outputsOf(options), aspect);
    if (!opened) return opened;
    const auto motion = motionFrom(options, opened->document, opened->study.phases.size());
    if (!motion) return tl::unexpected<Failure>(motion.error());
    sayNote(findsText(*opened));
    opened->document = withMethod(std::move(opened->document), *config);
    opened->document.motion = *motion;
    return opened;
}

/// Reads --document and its study. Fails (wrong usage) unless the pane is rendered with the adaptive OTF.
Result<DocumentStudy> documentForSweep(const SweepOptions& options) {
    auto read = readDocumentStudy(options.document.path, options.volume, outputsOf(options), options.document.view);
    if (!read || isAdaptive(read->document.panes.at(read->pane))) return read;
    return fail(FailureKind::wrongUsage, options.document.path, "panes",
                fmt::format("renders pane {} with {}, and a sweep is of the adaptive OTF", read->pane + 1,
                            otfNameOf(read->document, read->pane)),
                "Name another pane with --view.");
}

/// How the OTFs of the frames are smoothed; no value if one OTF is shown in all of them.
std::optional<OtfSmoothing> smoothingFrom(const SweepOptions& options, const DocumentStudy& made) {
    if (made.file.empty()) return otfSmoothingFromName(options.smoothing);
    const Pane& pane = made.document.panes.at(made.pane);
    const auto smoothing = smoothingOf(pane.motionOtf.value_or(made.document.motion.otf));
    // The OTF of a designer is not smoothed, and a pane's designer may be the adaptive method.
    return smoothing && pane.designer ? OtfSmoothing::none : smoothing;
}

Result<void> sweep(const SweepOptions& options, const CLI::App& command, const Invocation& invocation) {
    const auto range = rangeFrom(options);
    if (!range) return tl::unexpected<Failure>(range.error());
    const auto size = frameSizeFrom(options);
    if (!size) return tl::unexpected<Failure>(size.error());
    if (const auto length = lengthFrom(options); !length) return tl::unexpected<Failure>(length.error());
    if (auto possible = checkSweepOutputs(options, *size); !possible) return possible;
    if (auto checked = options.document.check(
            command, {"--from", "--to", "--step", "--csv", "--json", "--movie", "--picture-flicker", "--size",
                      "--frame-rate", "--loops", "--seconds", "--words"});
        !checked)
        return checked;
    const auto made = options.document.path.empty()
                          ? openedForSweep(options, static_cast<double>((*size)[0]) / (*size)[1])
                          : documentForSweep(options);
    if (!made) return tl::unexpected<Failure>(made.error());

    const Document& document = made->document;
    SweepReport report{.start = motionStartOf(document), .motion = document.motion};
    report.smoothing = smoothingFrom(options, *made);
    const Frames frames =
        framesFrom(options, *range, *made, framesUsed(report.smoothing.value_or(OtfSmoothing::none)) - 1);
    MoviePictures pictures;
    if (!options.movie.empty()) {
        auto counted = picturesFrom(options, *made, frames);
        if (!counted) return tl::unexpected<Failure>(counted.error());
        pictures = *std::move(counted);
    }
    if (!options.json.empty()) {
        auto of = madeOf(invocation, *made);
        if (!of) return tl::unexpected<Failure>(of.error());
        report.madeOf = *std::move(of);
    }
    StudyPhases phases{.scans = made->study.phases, .reduction = document.scene.look.reduction};
    // One OTF for all frames, without pictures, reads one phase only: the other phases need no quiet voxels.
    if (report.smoothing || options.pictureFlicker || !options.movie.empty())
        phases = withQuiet(std::move(phases), frames.frames);
    FrameCaster caster(*made, phases, report.smoothing);
    const std::vector<SweptOtf> swept = caster.otfs(frames);
    report.frames = swept;
    sayWhatIsMissing(made->study, swept, !options.movie.empty());
    if (auto done = writeReport(options, report, caster, *size); !done) return done;
    return options.movie.empty() ? Result<void>() : writeMovie(options, *made, swept, pictures, caster, *size);
}

void addMotion(CLI::App& command, SweepOptions& options) {
    const auto movement = CLI::IsMember({"still", "moving"});
    command
        .add_option("--axis", options.axis,
                    "Axis about which the probe turns: screen_vertical, screen_horizontal or picture_plane, or x, y or "
                    "z, which add to the view's angles")
        ->check(CLI::IsMember({"x", "y", "z", "screen_vertical", "screen_horizontal", "picture_plane"}))
        ->default_str("screen_vertical");
    command
        .add_option("--from", options.from,
                    "First angle from the given view, degrees; without --from, --to and --step the frames are a turn "
                    "of the window's motion [-45]")
        ->type_name("DEG");
    command.add_option("--to", options.to, "Last angle, degrees [45]")->type_name("DEG");
    command.add_option("--step", options.step, "Degrees a frame [1]")->type_name("DEG");
    command
        .add_option("--probe", options.probe,
                    "still (every frame from the given view) or moving [moving; still with a 4D volume if no angle "
                    "and no axis is given]")
        ->check(movement);
    command
        .add_option("--object", options.object,
                    "still, or moving: a 4D volume's phases, one a frame, over and over [moving with a 4D volume]")
        ->check(movement);
    auto* smoothing = command
                          .add_option("--smoothing", options.smoothing,
                                      "An OTF for each frame, smoothed: none, mean, mls or least-flicker "
                                      "(docs/motion.md); without it --static")
                          ->check(CLI::IsMember({"none", "mean", "mls", "least-flicker"}));
    command.add_flag("--static", options.oneOtf, "One OTF, that of the given view, for all frames")
        ->excludes(smoothing);
}

void addOutputs(CLI::App& command, SweepOptions& options) {
    command.add_option("--csv", options.csv, "The OTFs as shown, one frame a row; - is standard output")
        ->type_name("FILE");
    command.add_option("--json", options.json, "Frames and flicker figures; - is standard output")->type_name("FILE");
    auto* movie =
        command.add_option("--movie", options.movie, "The rendered frames; the name ends in .avi, .mp4 or .mkv")
            ->type_name("FILE.mp4");
    auto* loops =
        command.add_option("--loops", options.loops, "How often the movie shows its frames, over and over [1]")
            ->type_name("NUMBER")
            ->needs(movie);
    command
        .add_option("--seconds", options.seconds,
                    "How long the movie is; its frames are shown over and over, and the last loop may end early")
        ->type_name("SECONDS")
        ->needs(movie)
        ->excludes(loops);
    command.add_flag("--picture-flicker", options.pictureFlicker,
                     "Also the flicker of the pictures, into the JSON: renders each frame up to six times");
    command.add_option("--size", options.size, "Pixels of the movie and of --picture-flicker")
        ->type_name("WxH")
        ->capture_default_str();
    command.add_option("--frame-rate", options.frameRate, "Frames a second of the movie [as the window plays it]")
        ->type_name("RATE");
    command.add_flag("--words", options.words,
                     "Writes into each frame that the spacing is unknown or that the volume was reduced");
    options.look.addTo(command, {"reduction", "lighting"});
}

}  // namespace

void addSweepCommand(CLI::App& program, Action& action, const Invocation& invocation) {
    auto options = std::make_shared<SweepOptions>();
    CLI::App& command = *program.add_subcommand("sweep", "The OTFs of a moving probe, a moving object, or both");
    options->volume.addTo(command);
    options->document.addTo(command, "plays the motion of a pane of it");
    addMotion(command, *options);
    addOutputs(command, *options);
    options->view.addTo(command, ViewOf::openedStudy);
    options->method.addTo(command);
    command.footer("Example: echolucent-cli sweep heart.nrrd --movie heart.mp4");
    command.callback([options, &command, &action, invocation] {
        action = [options, &command, invocation] { return sweep(*options, command, invocation); };
    });
}

}  // namespace echolucent::cli
