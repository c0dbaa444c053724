#include "app/measuring/motion/motion_front.h"

#include <algorithm>

#include "app/measuring/measures/picture_difference.h"
#include "app/measuring/study_output.h"
#include "processing/adaptive/adaptive_otf.h"

namespace echolucent::cli {

namespace {

constexpr std::array allFronts{FrontOfFrames::turns, FrontOfFrames::fixed, FrontOfFrames::fixedStartDMax};

std::vector<SampledCurve> unsmoothedOf(const std::vector<SweptOtf>& swept) {
    std::vector<SampledCurve> curves;
    for (const SweptOtf& frame : swept) curves.push_back(frame.unsmoothed);
    return curves;
}

std::vector<SampledCurve> shownOf(const std::vector<SweptOtf>& swept) {
    std::vector<SampledCurve> curves;
    for (const SweptOtf& frame : swept) curves.push_back(frame.shown);
    return curves;
}

/// The config of the product with which a frame of `tubes` tube cores has the d_max of a view of `startTubes`.
AdaptiveOtfConfig withDMaxOf(AdaptiveOtfConfig config, int startTubes, int tubes) {
    const double share = static_cast<double>(tubes) / startTubes;
    std::get<ProductRule>(config.curve).strength *= share;
    return config;
}

FrontFigures figuresOf(const MotionCase& motionCase, const AdaptiveOtfConfig& config, FrontOfFrames front) {
    auto frames = motionFrames(motionCase.start, motionCase.motion, static_cast<int>(motionCase.phases.size()));
    if (front == FrontOfFrames::turns)
        for (SweepFrame& frame : frames) frame.view = withFrontAcross(frame.view, frontDepthMm(motionCase.start));
    const auto volumeOf = [&](const SweepFrame& frame) -> const Volume& {
        return *motionCase.phases[static_cast<std::size_t>(frame.phase)];
    };
    const int startTubes =
        std::max(1, adaptOpacity(volumeOf(frames.front()), motionCase.start, config)->tubesMeetingVolume);
    const FrameOtf otfOf = [&](const SweepFrame& frame, const Progress& progress) {
        auto otf = adaptOpacity(volumeOf(frame), frame.view, config, progress);
        if (!otf || front != FrontOfFrames::fixedStartDMax) return otf;
        return adaptOpacity(volumeOf(frame), frame.view, withDMaxOf(config, startTubes, otf->tubesMeetingVolume),
                            progress);
    };
    const auto swept = *sweepOtfs(frames, otfOf, OtfSmoothing::leastFlicker);
    const auto range = [&](auto member) { return std::ranges::minmax(swept, {}, member); };
    FrontFigures figures{.name = motionCase.name, .front = front};
    const auto tubes = range(&SweptOtf::tubesMeetingVolume), surfaces = range(&SweptOtf::tubesWithWeight),
               sums = range(&SweptOtf::sumOfD);
    figures.leastTubes = tubes.min.tubesMeetingVolume;
    figures.mostTubes = tubes.max.tubesMeetingVolume;
    figures.leastSurfaces = surfaces.min.tubesWithWeight;
    figures.mostSurfaces = surfaces.max.tubesWithWeight;
    figures.leastSumOfD = sums.min.sumOfD;
    figures.mostSumOfD = sums.max.sumOfD;
    figures.flicker = otfFlicker(unsmoothedOf(swept));
    figures.flickerLeft = otfFlicker(shownOf(swept));
    const auto apart = [&](std::size_t one, std::size_t other) {
        return rmsBetween(swept[one].unsmoothed, swept[other].unsmoothed);
    };
    const std::size_t last = swept.size() - 1, middle = last / 2;
    figures.rms = {apart(0, middle), apart(middle, last), apart(0, last)};
    return figures;
}

}  // namespace

std::string nameOf(FrontOfFrames front) {
    switch (front) {
        case FrontOfFrames::fixed: return "fixed";
        case FrontOfFrames::turns: return "turns along";
        case FrontOfFrames::fixedStartDMax: return "fixed, d_max of the start view";
    }
    return {};
}

std::vector<FrontFigures> measureFront(const MotionCase& motionCase, const AdaptiveOtfConfig& config) {
    std::vector<FrontFigures> figures;
    if (!motionCase.motion.probeMoves || motionCase.motion.objectMoves || !motionCase.start.frontPlane) return figures;
    const bool dMaxCounts = std::holds_alternative<ProductRule>(config.curve);
    for (const FrontOfFrames front : allFronts)
        if (front != FrontOfFrames::fixedStartDMax || dMaxCounts)
            figures.push_back(figuresOf(motionCase, config, front));
    return figures;
}

std::string motionFrontTable(const std::vector<FrontFigures>& figures) {
    CsvTable table({"case", "front", "least_tubes", "most_tubes", "least_surfaces", "most_surfaces", "least_sum_of_d",
                    "most_sum_of_d", "otf_flicker", "otf_flicker_left", "rms_first_middle", "rms_middle_last",
                    "rms_first_last"});
    for (const FrontFigures& one : figures)
        table.row({one.name, nameOf(one.front), one.leastTubes, one.mostTubes, one.leastSurfaces, one.mostSurfaces,
                   one.leastSumOfD, one.mostSumOfD, one.flicker, one.flickerLeft, one.rms[0], one.rms[1], one.rms[2]});
    return table.text();
}

}  // namespace echolucent::cli
