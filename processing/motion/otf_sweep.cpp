#include "processing/motion/otf_sweep.h"

#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "processing/adaptive/adaptive_otf.h"
#include "processing/parallel.h"
#include "processing/progress_count.h"

namespace echolucent {

namespace {

/// More frames come from a mistyped step, not from a wish.
constexpr double mostFrames = 1e6;
/// Slack for rounding if the range is a whole number of steps.
constexpr double stepRounding = 1e-9;

bool sameOtf(const SweepFrame& left, const SweepFrame& right) {
    return left.phase == right.phase && left.view == right.view;
}

/// For each frame the first one with the same phase and view. There may be thousands of frames, so the frames are
/// sorted, and only neighbours are compared. The key leaves out box and front: frames that differ in these alone
/// may come between equal ones, which are then not found.
std::vector<std::size_t> firstOfEqual(std::span<const SweepFrame> frames) {
    std::vector<std::size_t> order(frames.size()), first(frames.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto key = [&](std::size_t i) {
        const Viewpoint& view = frames[i].view;
        return std::tuple(frames[i].phase, view.beamAxis, view.azimuthDegrees, view.elevationDegrees, view.rollDegrees);
    };
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t left, std::size_t right) { return key(left) < key(right); });
    for (std::size_t i = 0; i < order.size(); ++i)
        first[order[i]] = i > 0 && sameOtf(frames[order[i]], frames[order[i - 1]]) ? first[order[i - 1]] : order[i];
    return first;
}

void check(std::span<const std::shared_ptr<const Volume>> phases, std::span<const SweepFrame> frames) {
    for (const SweepFrame& frame : frames)
        if (frame.phase < 0 || static_cast<std::size_t>(frame.phase) >= phases.size() ||
            !phases[static_cast<std::size_t>(frame.phase)])
            throw std::invalid_argument("sweepOtfs: a frame's phase is not there");
}

/// Computes the frames at the places `wanted` side by side. False if the work was cancelled.
bool computeFrames(std::span<const SweepFrame> frames, std::span<const std::size_t> wanted, const FrameOtf& otfOf,
                   const Progress& progress, std::span<SweptOtf> results) {
    ProgressCount count(progress, wanted.size());
    const Progress quiet{{}, progress.cancel};
    parallelFor(LoopRange<std::size_t>(0, wanted.size(), 1), [&](const auto& range) {
        for (std::size_t i = range.begin(); i < range.end() && !progress.cancelled(); ++i) {
            const SweepFrame& frame = frames[wanted[i]];
            // A thread that waits for a frame's tube cores must not begin another frame: frames would pile up on its
            // stack.
            const auto otf = tbb::this_task_arena::isolate([&] { return otfOf(frame, quiet); });
            if (!otf) return;
            results[wanted[i]] = {.frame = frame, .unsmoothed = otf->curve, .shown = {}};
            results[wanted[i]].tubesMeetingVolume = otf->tubesMeetingVolume;
            results[wanted[i]].tubesWithWeight = otf->tubesWithWeight;
            results[wanted[i]].sumOfD = sumOfD(*otf);
            count.oneDone();
        }
    });
    return !progress.cancelled();
}

}  // namespace

Viewpoint turned(const Viewpoint& start, MotionAxis axis, double degrees) {
    if (axis == MotionAxis::screenVertical) return turnedAbout(start, {0, 1, 0}, degrees);
    if (axis == MotionAxis::screenHorizontal) return turnedAbout(start, {1, 0, 0}, degrees);
    Viewpoint view = start;
    double& angle = axis == MotionAxis::x   ? view.elevationDegrees
                    : axis == MotionAxis::y ? view.azimuthDegrees
                                            : view.rollDegrees;
    angle += degrees;
    return view;
}

std::vector<SweepFrame> framesOf(std::span<const SweptOtf> swept) {
    std::vector<SweepFrame> frames;
    for (const SweptOtf& frame : swept) frames.push_back(frame.frame);
    return frames;
}

std::vector<SweepFrame> sweepFrames(const Viewpoint& start, MotionAxis axis, double from, double to, double step,
                                    int phases) {
    if (!std::isfinite(from) || !std::isfinite(to) || !(step > 0.0) || phases < 1)
        throw std::invalid_argument("sweepFrames: needs finite angles, a step above 0 and a phase");
    const double steps = std::floor(std::abs(to - from) / step + stepRounding);
    if (!(steps < mostFrames)) throw std::invalid_argument("sweepFrames: more than a million frames");
    std::vector<SweepFrame> frames;
    for (int i = 0; i <= static_cast<int>(steps); ++i) {
        // Each angle is computed from the first, not summed up: a hundred steps of 0.1 must end where they should.
        const double degrees = from + (to < from ? -step : step) * i;
        frames.push_back({static_cast<double>(i), degrees, i % phases, turned(start, axis, degrees)});
    }
    return frames;
}

std::vector<SweepFrame> motionFrames(const Viewpoint& start, const Motion& motion, int phases) {
    if (motion.firstPhase < 0 || motion.firstPhase >= phases)
        throw std::invalid_argument("motionFrames: the first phase is not there");
    std::vector<SweepFrame> frames =
        sweepFrames(start, motion.axis, motion.from, motion.to, motion.step, motion.objectMoves ? phases : 1);
    for (SweepFrame& frame : frames) {
        frame.phase = (frame.phase + motion.firstPhase) % phases;
        if (motion.probeMoves) continue;
        frame.degrees = 0.0;
        frame.view = start;
    }
    return frames;
}

std::optional<std::vector<SweptOtf>> sweepOtfs(std::span<const SweepFrame> frames, const FrameOtf& otfOf,
                                               OtfSmoothing smoothing, const Progress& progress) {
    const std::vector<std::size_t> first = firstOfEqual(frames);
    std::vector<std::size_t> wanted;
    for (std::size_t i = 0; i < frames.size(); ++i)
        if (first[i] == i) wanted.push_back(i);
    std::vector<SweptOtf> otfs(frames.size());
    if (!computeFrames(frames, wanted, otfOf, progress, otfs)) return std::nullopt;

    std::vector<SweptOtf> swept;
    OtfHistory history(smoothing);
    for (std::size_t i = 0; i < frames.size(); ++i) {
        swept.push_back(otfs[first[i]]);
        swept.back().frame = frames[i];
        swept.back().shown = history.add(frames[i].time, swept.back().unsmoothed);
    }
    return swept;
}

std::optional<std::vector<SweptOtf>> sweepOtfs(std::span<const std::shared_ptr<const Volume>> phases,
                                               std::span<const SweepFrame> frames, const AdaptiveOtfConfig& config,
                                               OtfSmoothing smoothing, const Progress& progress) {
    check(phases, frames);
    const FrameOtf otfOf = [&](const SweepFrame& frame, const Progress& quiet) {
        return adaptOpacity(*phases[static_cast<std::size_t>(frame.phase)], frame.view, config, quiet);
    };
    return sweepOtfs(frames, otfOf, smoothing, progress);
}

}  // namespace echolucent
