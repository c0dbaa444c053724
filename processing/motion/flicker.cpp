#include "processing/motion/flicker.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>

#include "processing/picture/view_limits.h"
#include "processing/ray_caster/ray_caster.h"

namespace echolucent {

namespace {

constexpr std::size_t channels = 4;  // of a picture's pixel; the last is alpha

struct SquareSum {
    double sum = 0.0;
    std::size_t count = 0;
    void add(double value) {
        sum += value * value;
        ++count;
    }
    [[nodiscard]] double rms() const { return count > 0 ? std::sqrt(sum / static_cast<double>(count)) : 0.0; }
};

void addPixels(const Picture& newest, const Picture& before, const Picture* second, SquareSum& squares) {
    for (std::size_t i = 0; i < newest.rgba.size(); ++i) {
        if (i % channels == channels - 1) continue;
        const double change = static_cast<double>(newest.rgba[i]) - before.rgba[i];
        squares.add(second ? change - (static_cast<double>(before.rgba[i]) - second->rgba[i]) : change);
    }
}

/// For either kind of OTF.
template <typename Otf, typename Renderer>
std::optional<PictureFlicker> flickerOf(std::span<const SweepFrame> frames, std::span<const Otf> otfs,
                                        const Renderer& render, const Progress& progress) {
    if (frames.size() != otfs.size()) throw std::invalid_argument("pictureFlicker: as many OTFs as frames are needed");
    if (std::ranges::adjacent_find(otfs, std::not_equal_to<>()) == otfs.end()) return PictureFlicker{};
    SquareSum changes, flickers;
    for (std::size_t k = 1; k < frames.size(); ++k) {
        // Equal OTFs give equal pictures, so an OTF that equals its neighbour is not rendered again.
        const auto newest = render(frames[k], otfs[k]);
        const auto before = otfs[k] == otfs[k - 1] ? newest : render(frames[k], otfs[k - 1]);
        if (!newest || !before) return std::nullopt;
        addPixels(*newest, *before, nullptr, changes);
        if (k >= 2) {
            const auto second = otfs[k - 1] == otfs[k - 2] ? before : render(frames[k], otfs[k - 2]);
            if (!second) return std::nullopt;
            addPixels(*newest, *before, &*second, flickers);
        }
        progress.at(static_cast<double>(k) / static_cast<double>(frames.size() - 1));
    }
    return PictureFlicker{changes.rms(), flickers.rms()};
}

}  // namespace

double otfFlicker(std::span<const SampledCurve> otfs) {
    SquareSum squares;
    for (std::size_t k = 2; k < otfs.size(); ++k) {
        const auto &now = otfs[k].opacities, &before = otfs[k - 1].opacities, &second = otfs[k - 2].opacities;
        if (now.size() != before.size() || now.size() != second.size())
            throw std::invalid_argument("otfFlicker: the OTFs' numbers of samples differ");
        for (std::size_t i = 0; i < now.size(); ++i) squares.add(now[i] - 2.0 * before[i] + second[i]);
    }
    return squares.rms();
}

FrameRenderer frameRenderer(std::span<const std::shared_ptr<const Volume>> phases, std::span<const SweepFrame> frames,
                            const RayCastSettings& settings, const Progress& progress) {
    const double aspect = static_cast<double>(settings.width) / settings.height;
    const auto volumeOf = [phases](const SweepFrame& frame) -> const Volume& {
        return *phases[static_cast<std::size_t>(frame.phase)];
    };
    double heightMm = 0.0;
    for (const SweepFrame& frame : frames)
        heightMm = std::max(heightMm, defaultCamera(volumeOf(frame).dataBox(), frame.view, aspect).heightMm);
    // Each caster is made when a frame first needs it. It keeps the samples of a view for several OTFs.
    auto casters = std::make_shared<std::vector<std::optional<RayCaster>>>(phases.size());
    return [volumes = std::vector(phases.begin(), phases.end()), casters, heightMm, aspect, settings, progress](
               const SweepFrame& frame, const SampledCurve& otf) {
        const auto phase = static_cast<std::size_t>(frame.phase);
        const Volume& volume = *volumes.at(phase);
        std::optional<RayCaster>& caster = (*casters)[phase];
        if (!caster) caster.emplace(volumes[phase]);
        RayCastSettings ofFrame = settings;
        ofFrame.camera = defaultCamera(volume.dataBox(), frame.view, aspect);
        // All frames have one scale: otherwise the box would seem to come and go while the view turns.
        ofFrame.camera.heightMm = heightMm;
        ofFrame = limitedTo(frame.view, volume.geometry(), ofFrame);
        return caster->cast(otf, ofFrame, {{}, progress.cancel});
    };
}

std::optional<PictureFlicker> pictureFlicker(std::span<const SweepFrame> frames, std::span<const SampledCurve> otfs,
                                             const FrameRenderer& render, const Progress& progress) {
    return flickerOf(frames, otfs, render, progress);
}

std::optional<PictureFlicker> pictureFlicker(std::span<const SweepFrame> frames,
                                             std::span<const Classification> classifications,
                                             const ClassificationRenderer& render, const Progress& progress) {
    return flickerOf(frames, classifications, render, progress);
}

SmoothingLag lagOf(OtfSmoothing smoothing) {
    constexpr int settled = 20;  // frames, beyond any smoothing's memory
    const auto opacityOf = [](OtfHistory& history, int frame, double opacity) {
        return history.add(frame, SampledCurve{{opacity, opacity}}).opacities.front();
    };
    // The step lies half-way between 0 and 1, so that no overshoot is clamped.
    constexpr double slope = 0.01, low = 0.25, high = 0.75, nearlyDone = 0.9;
    SmoothingLag lag;
    OtfHistory onRamp(smoothing), onStep(smoothing);
    double shown = 0.0;
    for (int frame = 0; frame <= settled; ++frame) shown = opacityOf(onRamp, frame, slope * frame);
    lag.ramp = settled - shown / slope;
    for (int frame = 0; frame < settled; ++frame) (void)opacityOf(onStep, frame, low);
    for (int frame = 0; frame < settled; ++frame) {
        const double share = (opacityOf(onStep, settled + frame, high) - low) / (high - low);
        if (share < nearlyDone) lag.stepToNineTenths = frame + 1;
        lag.overshoot = std::max(lag.overshoot, share - 1.0);
    }
    return lag;
}

}  // namespace echolucent
