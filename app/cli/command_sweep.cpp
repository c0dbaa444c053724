#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <memory>
#include <optional>
#include <utility>

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
#include "io/output/atomic_file.h"
#include "io/study/import_report.h"
#include "io/writers/movie_file.h"
#include "processing/motion/flicker.h"
#include "processing/motion/otf_sweep.h"
#include "processing/pane_picture/pane_caster.h"
#include "processing/pane_picture/pane_frames.h"
#include "processing/speckle_reduction/speckle_reduction.h"

namespace echolucent::cli {

namespace {

struct SweepOptions {
    VolumeOptions volume;
    ViewOptions view;
    MethodOptions method;
    LookOptions look;
    std::string axis, smoothing, object, probe, size = "512x512";
    std::optional<double> from, to, step, frameRate;
    bool oneOtf = false, pictureFlicker = false, words = false;
    std::string csv, json, movie;

    [[nodiscard]] bool angles() const { return from || to || step; }
};

constexpr int largestFrameEdge = 4096;
constexpr double mostFrames = 100'000;
constexpr double leastFrameRate = 1.0, largestFrameRate = 1000.0;

Result<std::array<int, 2>> frameSizeFrom(const SweepOptions& options) {
    if (options.frameRate && !(*options.frameRate >= leastFrameRate && *options.frameRate <= largestFrameRate))
        return wrongUsage("--frame-rate", "must be 1 to 1000 a second");
    return parseWholePair(options.size, 1, largestFrameEdge, "--size", "512x512");
}

/// The range of angles, which does not yet say what moves.
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

/// The motion that the window begins with, as the options edit it.
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

/// The frames, and how many of the last ones count as having been shown before the first.
struct Frames {
    std::vector<SweepFrame> frames;
    std::size_t before = 0;
};

/// The frames of a range of angles. Without a range: one turn of the document's motion, which repeats.
Frames framesFrom(const SweepOptions& options, Motion range, const Document& document, std::size_t phases,
                  std::size_t framesUsed) {
    const Viewpoint start = viewpointOf(document);
    if (options.angles()) {
        range.axis = document.motion.axis;
        range.probeMoves = movesProbe(document.motion.scenario);
        range.objectMoves = movesObject(document.motion.scenario);
        range.firstPhase = document.scene.phase;
        return {motionFrames(start, range, static_cast<int>(phases))};
    }
    Frames turn;
    for (const MotionPosition& at : turnOf(document, firstPane, static_cast<int>(phases)))
        turn.frames.push_back({static_cast<double>(turn.frames.size()), static_cast<double>(at.angle), at.phase,
                               turned(start, document.motion.axis, at.angle)});
    turn.before = framesUsed - 1;
    return turn;
}

/// The frames with those that were shown before the first of them.
std::vector<SweepFrame> withBefore(const Frames& turn) {
    std::vector<SweepFrame> all;
    const auto count = static_cast<std::ptrdiff_t>(turn.frames.size());
    for (auto i = -static_cast<std::ptrdiff_t>(turn.before); i < count; ++i) {
        all.push_back(turn.frames[static_cast<std::size_t>((i % count + count) % count)]);
        all.back().time = static_cast<double>(i);
    }
    return all;
}

/// The phases, with quiet voxels of those that the frames show.
StudyPhases withQuiet(StudyPhases phases, const std::vector<SweepFrame>& frames) {
    if (phases.reduction == SpeckleReduction::off) return phases;
    phases.quiet.resize(phases.scans.size());
    for (const SweepFrame& frame : frames) {
        const auto place = static_cast<std::size_t>(frame.phase);
        const Volume& scan = *phases.scans[place];
        if (!phases.quiet[place])
            phases.quiet[place] =
                std::make_shared<const Volume>(quietVolume(scan, phases.reduction)->withDataBox(scan.dataBox()));
    }
    return phases;
}

std::vector<QuietVoxels> shownVoxels(const StudyPhases& phases) {
    std::vector<QuietVoxels> shown;
    for (const auto& quiet : phases.quiet) shown.push_back({quiet.get(), phases.reduction});
    return shown;
}

/// The OTF of the view from which the motion begins, for all frames.
std::vector<SweptOtf> withOneOtf(const Document& document, const StudyPhases& phases,
                                 const std::vector<SweepFrame>& frames) {
    const AdaptiveOtf otf = PaneCaster(phases).readTubeCores(document, firstPane)->otf;
    double sumOfD = 0.0;
    for (const TubeCore& tube : otf.tubes) sumOfD += tube.d;
    std::vector<SweptOtf> swept;
    swept.reserve(frames.size());
    for (const SweepFrame& frame : frames) swept.push_back({frame, otf.curve, otf.curve, sumOfD, otf.tubesWithWeight});
    return swept;
}

/// The OTF of each frame's own view and phase, smoothed over the frames before it.
std::vector<SweptOtf> withOwnOtfs(const Document& document, const StudyPhases& phases, const Frames& frames,
                                  OtfSmoothing smoothing) {
    auto swept =
        *sweepOtfs(phases.scans, withBefore(frames), configOf(document, firstPane), smoothing, {}, shownVoxels(phases));
    swept.erase(swept.begin(), swept.begin() + static_cast<std::ptrdiff_t>(frames.before));
    return swept;
}

/// Casts the frames of a document's motion as the window shows them at rest.
class FramePictures {
public:
    FramePictures(Document document, const StudyPhases& phases, const std::array<int, 2>& size)
        : m_document(std::move(document)), m_caster(phases), m_size(size) {}

    Picture of(const SweepFrame& frame, const SampledCurve& curve) {
        m_document.scene.motionAngle = frame.degrees;
        m_document.scene.phase = frame.phase;
        return std::move(m_caster.pictureWith({.curve = curve}, m_document, firstPane, m_size[0], m_size[1])->picture);
    }

private:
    Document m_document;
    PaneCaster m_caster;
    std::array<int, 2> m_size;
};

Result<void> writeMovie(const SweepOptions& options, const DocumentStudy& opened, const std::vector<SweptOtf>& swept,
                        FramePictures& pictures, const std::array<int, 2>& size) {
    const double asShown = 1.0 / frameSeconds(opened.document.motion, opened.study.phaseSeconds);
    const double rate = options.frameRate.value_or(std::clamp(asShown, leastFrameRate, largestFrameRate));
    auto movie = MovieFile::begin(options.movie, size[0], size[1], rate);
    if (!movie) return tl::unexpected<Failure>(movie.error());
    const std::string words = options.words ? pictureWordsOf(opened.study.phases.front()->geometry()) : "";
    for (const SweptOtf& frame : swept) {
        std::vector<std::uint8_t> rgb = overBackground(pictures.of(frame.frame, frame.shown), Vec3(0, 0, 0));
        writeWords(rgb, size[0], size[1], words);
        if (auto added = movie->add(rgb); !added) return added;
    }
    return movie->finish();
}

Result<void> writeReport(const SweepOptions& options, SweepReport& report, FramePictures& pictures) {
    if (options.pictureFlicker) {
        const std::vector<SweepFrame> frames = framesOf(report.frames);
        const FrameRenderer render = [&](const SweepFrame& frame, const SampledCurve& curve) {
            return std::optional(pictures.of(frame, curve));
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

Result<void> sweep(const SweepOptions& options, const Invocation& invocation) {
    const auto range = rangeFrom(options);
    if (!range) return tl::unexpected<Failure>(range.error());
    const auto size = frameSizeFrom(options);
    if (!size) return tl::unexpected<Failure>(size.error());
    if (auto possible = checkSweepOutputs(options, *size); !possible) return possible;
    const auto config = options.method.get();
    if (!config) return tl::unexpected<Failure>(config.error());
    const auto look = options.look.get();
    if (!look) return tl::unexpected<Failure>(look.error());
    auto opened = openStudy(options.volume, options.view, *look, outputsOf(options),
                            static_cast<double>((*size)[0]) / (*size)[1]);
    if (!opened) return tl::unexpected<Failure>(opened.error());
    const auto motion = motionFrom(options, opened->document, opened->study.phases.size());
    if (!motion) return tl::unexpected<Failure>(motion.error());
    sayNote(findsText(*opened));

    Document& document = opened->document;
    document = withMethod(std::move(document), *config);
    document.motion = *motion;
    SweepReport report{.motion = *motion};
    report.start = viewpointOf(document);
    report.smoothing = otfSmoothingFromName(options.smoothing);
    const Frames frames = framesFrom(options, *range, document, opened->study.phases.size(),
                                     framesUsed(report.smoothing.value_or(OtfSmoothing::none)));
    if (!options.json.empty()) {
        auto made = madeOf(invocation, *opened);
        if (!made) return tl::unexpected<Failure>(made.error());
        report.madeOf = *std::move(made);
    }
    StudyPhases phases{.scans = opened->study.phases, .reduction = document.scene.look.reduction};
    // One OTF alone is computed of one phase.
    if (report.smoothing || options.pictureFlicker || !options.movie.empty())
        phases = withQuiet(std::move(phases), frames.frames);
    const std::vector<SweptOtf> swept = report.smoothing ? withOwnOtfs(document, phases, frames, *report.smoothing)
                                                         : withOneOtf(document, phases, frames.frames);
    report.frames = swept;
    sayWhatIsMissing(opened->study, swept, !options.movie.empty());
    FramePictures pictures(document, phases, *size);
    if (auto done = writeReport(options, report, pictures); !done) return done;
    return options.movie.empty() ? Result<void>() : writeMovie(options, *opened, swept, pictures, *size);
}

void addMotion(CLI::App& command, SweepOptions& options) {
    const auto movement = CLI::IsMember({"still", "moving"});
    command.add_option("--axis", options.axis, "Axis of the view about which the probe turns: x, y or z")
        ->check(CLI::IsMember({"x", "y", "z"}))
        ->default_str("y");
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
    command.add_option("--movie", options.movie, "The rendered frames; the name ends in .avi, .mp4 or .mkv")
        ->type_name("FILE.mp4");
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
    addMotion(command, *options);
    addOutputs(command, *options);
    options->view.addTo(command, ViewOf::openedStudy);
    options->method.addTo(command);
    command.footer("Example: echolucent-cli sweep heart.nrrd --movie heart.mp4");
    command.callback(
        [options, &action, invocation] { action = [options, invocation] { return sweep(*options, invocation); }; });
}

}  // namespace echolucent::cli
