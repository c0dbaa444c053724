#include "app/measuring/motion/motion_measure.h"
#include "processing/adaptive/adaptive_otf.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/measuring/measures/picture_difference.h"

namespace echolucent::cli {

namespace {

RayCastSettings pictureSettings(int edge) {
    RayCastSettings settings;
    settings.width = settings.height = edge;
    settings.colourMap = ColourMap::grey;
    return settings;
}

std::vector<SampledCurve> smoothed(const std::vector<SweptOtf>& frames, OtfSmoothing smoothing) {
    OtfHistory history(smoothing);
    std::vector<SampledCurve> shown;
    shown.reserve(frames.size());
    for (const SweptOtf& frame : frames) shown.push_back(history.add(frame.frame.time, frame.unsmoothed));
    return shown;
}

/// The range of the weighted sums before the clamp.
std::pair<double, double> unclampedRange(const std::vector<SweptOtf>& frames, OtfSmoothing smoothing) {
    double lowest = 1.0, highest = 0.0;
    for (std::size_t k = 0; k < frames.size(); ++k) {
        const std::size_t count = std::min(k + 1, framesUsed(smoothing)), oldest = k + 1 - count;
        std::vector<double> times;
        for (std::size_t i = oldest; i <= k; ++i) times.push_back(frames[i].frame.time);
        const std::vector<double> weights = smoothingWeights(smoothing, times);
        for (std::size_t sample = 0; sample < frames[k].unsmoothed.opacities.size(); ++sample) {
            double opacity = 0.0;
            for (std::size_t i = 0; i < count; ++i)
                opacity += weights[i] * frames[oldest + i].unsmoothed.opacities[sample];
            lowest = std::min(lowest, opacity);
            highest = std::max(highest, opacity);
        }
    }
    return {lowest, highest};
}

ModeFigures measureMode(const MotionMode& mode, const MotionFigures& figures, const FrameRenderer& render) {
    ModeFigures result{.mode = mode, .shown = {}, .otfFlicker = 0.0, .pictures = {}};
    if (!mode) {
        result.shown.assign(figures.frames.size(), figures.oneOtf);
        const auto [lowest, highest] =
            std::minmax_element(figures.oneOtf.opacities.begin(), figures.oneOtf.opacities.end());
        result.lowest = *lowest;
        result.highest = *highest;
    } else {
        result.shown = smoothed(figures.frames, *mode);
        std::tie(result.lowest, result.highest) = unclampedRange(figures.frames, *mode);
    }
    result.otfFlicker = otfFlicker(result.shown);
    // With one OTF for all frames, no picture changes because of its OTF: the flicker stays 0.
    if (mode) result.pictures = *pictureFlicker(framesOf(figures.frames), result.shown, render);
    return result;
}

double largestOf(const SampledCurve& left, const SampledCurve& right) {
    double largest = 0.0;
    for (std::size_t i = 0; i < left.opacities.size(); ++i)
        largest = std::max(largest, std::abs(left.opacities[i] - right.opacities[i]));
    return largest;
}

std::string nameOfFrame(const MotionFigures& figures, std::size_t index) {
    const SweepFrame& frame = figures.frames[index].frame;
    return figures.motionCase.motion.probeMoves ? fmt::format("{:g}°", frame.degrees) : fmt::format("frame {}", index);
}

/// Compares the first, the middle and the last frame (-45, 0 and +45 degrees), as in the paper's Fig. 10.
void compareCurves(MotionFigures& figures, const FrameRenderer& render) {
    const std::size_t last = figures.frames.size() - 1, middle = last / 2;
    const SweepFrame& view = figures.frames[middle].frame;
    const auto with = [&](std::size_t index) { return *render(view, figures.frames[index].unsmoothed); };
    figures.adaptation = rmsBetween(figures.oneOtf, figures.initial);
    figures.adaptationPicture = differenceOf(*render(view, figures.oneOtf), *render(view, figures.initial)).rms;
    // If the probe is still, these three frames may show one phase. Nothing is compared.
    if (!figures.motionCase.motion.probeMoves) return;
    for (const auto& [left, right] :
         {std::pair(std::size_t{0}, middle), std::pair(middle, last), std::pair(std::size_t{0}, last)}) {
        const SampledCurve &one = figures.frames[left].unsmoothed, &other = figures.frames[right].unsmoothed;
        figures.differences.push_back({nameOfFrame(figures, left) + " and " + nameOfFrame(figures, right),
                                       rmsBetween(one, other), largestOf(one, other),
                                       differenceOf(with(left), with(right)).rms});
    }
}

void compareWithStatic(MotionFigures& figures, const FrameRenderer& render) {
    double squares = 0.0;
    for (const SweptOtf& frame : figures.frames) {
        const double rms =
            differenceOf(*render(frame.frame, figures.oneOtf), *render(frame.frame, frame.unsmoothed)).rms;
        squares += rms * rms;
        figures.worstStaticPictureRms = std::max(figures.worstStaticPictureRms, rms);
    }
    figures.staticPictureRms = std::sqrt(squares / static_cast<double>(figures.frames.size()));
}

/// Maps opacity to another quantity that is smoothed instead, scaled into [0,1], and back.
struct Domain {
    double (*forward)(double);
    double (*backward)(double);
};

double flickerLeft(const std::vector<SweptOtf>& frames, const Domain& domain) {
    OtfHistory history(OtfSmoothing::leastFlicker);
    std::vector<SampledCurve> before, after;
    for (const SweptOtf& frame : frames) {
        SampledCurve curve = frame.unsmoothed;
        for (double& opacity : curve.opacities) opacity = domain.forward(opacity);
        SampledCurve shown = history.add(frame.frame.time, curve);
        for (double& opacity : curve.opacities) opacity = domain.backward(opacity);
        for (double& opacity : shown.opacities) opacity = domain.backward(opacity);
        before.push_back(std::move(curve));
        after.push_back(std::move(shown));
    }
    const double unsmoothed = otfFlicker(before);
    return unsmoothed > 0.0 ? otfFlicker(after) / unsmoothed : 0.0;
}

// The logarithm ends at ln(1e-4), the extinction at -ln(1e-3).
constexpr double lowestLogarithm = -9.210340371976182;
constexpr double highestExtinction = 6.907755278982137;

DomainFigures domainsOf(const std::vector<SweptOtf>& frames) {
    const auto same = [](double value) { return value; };
    return {flickerLeft(frames, {same, same}),
            flickerLeft(frames, {[](double a) { return 1.0 - std::log(std::max(a, 1e-4)) / lowestLogarithm; },
                                 [](double y) { return std::exp((1.0 - y) * lowestLogarithm); }}),
            flickerLeft(frames, {[](double a) { return -std::log1p(-std::min(a, 1.0 - 1e-3)) / highestExtinction; },
                                 [](double y) { return -std::expm1(-y * highestExtinction); }})};
}

/// Takes pictures at both ends of the motion, with the one OTF and with the frame's own.
void takeStills(MotionFigures& figures, int edge) {
    RayCastSettings settings = pictureSettings(edge);
    settings.colourMap = ColourMap::sepia;
    settings.shading = Shading{};
    const FrameRenderer render = frameRenderer(figures.motionCase.phases, framesOf(figures.frames), settings);
    for (const std::size_t index : {std::size_t{0}, figures.frames.size() - 1}) {
        const SweptOtf& frame = figures.frames[index];
        const std::string name = nameOfFrame(figures, index);
        figures.stills.push_back({name + ", one OTF for all views", *render(frame.frame, figures.oneOtf)});
        figures.stills.push_back({name + ", the view's own OTF", *render(frame.frame, frame.unsmoothed)});
    }
}

}  // namespace

std::vector<MotionMode> motionModes() {
    return {std::nullopt, OtfSmoothing::none, OtfSmoothing::mean, OtfSmoothing::movingLeastSquares,
            OtfSmoothing::leastFlicker};
}

double rmsBetween(const SampledCurve& one, const SampledCurve& other) {
    double squares = 0.0;
    for (std::size_t i = 0; i < one.opacities.size(); ++i) {
        const double difference = one.opacities[i] - other.opacities[i];
        squares += difference * difference;
    }
    return std::sqrt(squares / static_cast<double>(one.opacities.size()));
}

std::string nameOf(const MotionMode& mode) { return mode ? std::string(nameOf(*mode)) : "static"; }

MotionFigures measureMotion(const MotionCase& motionCase, const AdaptiveOtfConfig& config, int edge, int stillEdge) {
    MotionFigures figures;
    figures.motionCase = motionCase;
    const auto frames = motionFrames(motionCase.start, motionCase.motion, static_cast<int>(motionCase.phases.size()));
    figures.frames = *sweepOtfs(motionCase.phases, frames, config, OtfSmoothing::none);
    figures.initial = SampledCurve{sampledOpacities(config.initial, AdaptiveOtf::sampleCount)};
    const auto& first = *motionCase.phases[static_cast<std::size_t>(motionCase.motion.firstPhase)];
    figures.oneOtf = adaptOpacity(first, motionCase.start, config)->curve;
    const FrameRenderer render = frameRenderer(motionCase.phases, frames, pictureSettings(edge));
    for (const MotionMode& mode : motionModes()) figures.modes.push_back(measureMode(mode, figures, render));
    compareCurves(figures, render);
    compareWithStatic(figures, render);
    figures.domains = domainsOf(figures.frames);
    if (motionCase.stills) takeStills(figures, stillEdge);
    return figures;
}

}  // namespace echolucent::cli
