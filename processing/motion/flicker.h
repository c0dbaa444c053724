// How much OTFs and pictures flicker in a motion, and how late a smoothing shows a change.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>

#include "processing/classification.h"
#include "processing/motion/otf_smoothing.h"
#include "processing/motion/otf_sweep.h"
#include "processing/picture/picture.h"
#include "processing/picture/ray_cast_settings.h"
#include "processing/progress.h"
#include "processing/volume/volume.h"

namespace echolucent {

/// Flicker of OTFs: the RMS of the second temporal difference of opacity, alpha_k - 2 alpha_(k-1) + alpha_(k-2), over
/// intensities and over frames from the third on. A steady change adds nothing. Fewer than three frames give 0. Throws
/// std::invalid_argument if the numbers of samples differ.
[[nodiscard]] double otfFlicker(std::span<const SampledCurve> otfs);

/// What the OTFs alone change in the pictures of a motion. Each figure compares pictures of one view and phase, so it
/// is free of the rotation and of the object's motion. RMS over pixels, colours and frames.
struct PictureFlicker {
    double change = 0.0;  ///< picture(k, otf_k) - picture(k, otf_(k-1)), from the second frame on
    /// picture(k, otf_k) - 2 picture(k, otf_(k-1)) + picture(k, otf_(k-2)), from the third frame on; a steady change
    /// adds little.
    double flicker = 0.0;
};

/// Renders a frame's view and phase with an OTF. The result is empty only if the work was cancelled.
using FrameRenderer = std::function<std::optional<Picture>(const SweepFrame&, const SampledCurve&)>;
/// Like FrameRenderer, with any classification in place of the curve.
using ClassificationRenderer = std::function<std::optional<Picture>(const SweepFrame&, const Classification&)>;

/// Renders frames of a motion with `settings` in parallel projection. Only one thread at a time may call the result.
/// Direction, near plane, cut surface and box follow each frame's view. All frames have one scale, so that each frame's
/// whole box fits into its picture. `progress` only cancels. Every frame's phase must be in `phases`.
[[nodiscard]] FrameRenderer frameRenderer(std::span<const std::shared_ptr<const Volume>> phases,
                                          std::span<const SweepFrame> frames, const RayCastSettings& settings,
                                          const Progress& progress = {});

/// Measures the flicker of the OTFs as shown, one a frame; fewer than two frames give 0. It renders up to three
/// pictures a frame, and none if all OTFs are equal: equal OTFs give equal pictures. The result is empty only if the
/// work was cancelled. Throws std::invalid_argument if the numbers of frames and OTFs differ.
[[nodiscard]] std::optional<PictureFlicker> pictureFlicker(std::span<const SweepFrame> frames,
                                                           std::span<const SampledCurve> otfs,
                                                           const FrameRenderer& render, const Progress& progress = {});
/// Like pictureFlicker() of curves, with any classifications.
[[nodiscard]] std::optional<PictureFlicker> pictureFlicker(std::span<const SweepFrame> frames,
                                                           std::span<const Classification> classifications,
                                                           const ClassificationRenderer& render,
                                                           const Progress& progress = {});

/// How late a smoothing shows a change, measured on an OTF that changes between equal frames.
struct SmoothingLag {
    double ramp = 0.0;  ///< frames by which a steady change is shown late
    /// Frames after the first changed one until a sudden change is shown to 90 % and stays so.
    int stepToNineTenths = 0;
    /// How far the shown OTF overshoots a sudden change, as a share of the change. The change is small enough that the
    /// clamp to [0,1] takes nothing off.
    double overshoot = 0.0;
};
[[nodiscard]] SmoothingLag lagOf(OtfSmoothing smoothing);

}  // namespace echolucent
