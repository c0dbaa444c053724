#include "processing/motion/motion_choice.h"

#include <algorithm>
#include <cmath>

namespace echolucent {

namespace {

struct Step {
    int value;
    bool back;
};

/// The next value of a count from `first` to `last`. After a value outside of them comes `first`.
Step next(int value, bool back, int first, int last, bool pingPong) {
    if (value < first || value > last || first == last) return {first, false};
    if (!pingPong) return {value == last ? first : value + 1, false};
    if (value == last) back = true;
    if (value == first) back = false;
    return {value + (back ? -1 : 1), back};
}

}  // namespace

PhaseRange playedPhases(const MotionChoice& motion, int phases) {
    const PhaseRange all{0, phases - 1};
    if (!motion.phaseRange) return all;
    return {std::clamp(motion.phaseRange->first, 0, all.last), std::clamp(motion.phaseRange->last, 0, all.last)};
}

double frameSeconds(const MotionChoice& motion, const PhaseTimes& times) { return frameSeconds(motion, times, 0, 0); }

double frameSeconds(const MotionChoice& motion, const PhaseTimes& times, int from, int to) {
    const double standard = movesObject(motion.scenario)
                                ? secondsBetween(times, from, to).value_or(1.0 / assumedPhasesPerSecond)
                                : 1.0 / motionDegreesPerSecond;
    return standard / motion.speed;
}

HeldFrames heldFrames(const MotionChoice& motion, const PhaseTimes& times, std::span<const int> phases,
                      double leastPictureSeconds) {
    std::vector<double> seconds;
    for (std::size_t frame = 0; frame < phases.size(); ++frame)
        seconds.push_back(frameSeconds(motion, times, phases[frame], phases[(frame + 1) % phases.size()]));
    HeldFrames held{.pictures = std::vector<int>(phases.size(), 1), .pictureSeconds = frameSeconds(motion, times)};
    if (seconds.empty() || times.starts.empty() || !movesObject(motion.scenario)) return held;
    constexpr double mostPictures = 100;
    const auto [shortest, longest] = std::ranges::minmax(seconds);
    held.pictureSeconds = std::max({shortest, longest / mostPictures, leastPictureSeconds});
    double end = 0;  // of the frames so far, in pictures
    double shown = 0;
    for (std::size_t frame = 0; frame < seconds.size(); ++frame) {
        end += seconds[frame] / held.pictureSeconds;
        held.pictures[frame] = static_cast<int>(std::max(1.0, std::round(end - shown)));
        shown += held.pictures[frame];
    }
    return held;
}

MotionPosition nextFrame(const MotionPosition& position, const MotionChoice& motion, int phases) {
    MotionPosition after = position;
    if (movesProbe(motion.scenario)) {
        const Step angle = next(position.angle, position.angleBack, firstMotionAngle, lastMotionAngle, motion.pingPong);
        after.angle = angle.value;
        after.angleBack = angle.back;
    }
    if (movesObject(motion.scenario)) {
        const PhaseRange range = playedPhases(motion, phases);
        const Step phase = next(position.phase, position.phaseBack, range.first, range.last, motion.phasesPingPong);
        after.phase = phase.value;
        after.phaseBack = phase.back;
    }
    return after;
}

std::vector<MotionPosition> framesOfTurn(const MotionChoice& motion, int phases, const MotionPosition& at) {
    MotionPosition first;
    first.angle = movesProbe(motion.scenario) ? firstMotionAngle : at.angle;
    first.phase = movesObject(motion.scenario) ? playedPhases(motion, phases).first : at.phase;
    const auto begins = [&](const MotionPosition& position) {
        return movesProbe(motion.scenario) ? position.angle == first.angle : position.phase == first.phase;
    };
    std::vector<MotionPosition> frames{first};
    for (MotionPosition next = nextFrame(first, motion, phases); !begins(next); next = nextFrame(next, motion, phases))
        frames.push_back(next);
    return frames;
}

std::string problemOf(const MotionChoice& motion) {
    if (!(motion.speed >= leastMotionSpeed && motion.speed <= largestMotionSpeed)) return "speed must be 1/16 to 16";
    if (motion.otfPhase < 0) return "otf_phase must not be negative";
    if (motion.phaseRange && (motion.phaseRange->first < 0 || motion.phaseRange->last < motion.phaseRange->first))
        return "phase_range must go from a phase to the same or a later one";
    return {};
}

}  // namespace echolucent
