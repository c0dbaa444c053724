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

/// Flicker of OTFs: the RMS, over the intensities and over the frames from the third on, of the second temporal
/// difference of opacity, alpha_k - 2 alpha_(k-1) + alpha_(k-2). A steady change counts for nothing. It is 0 for fewer
/// than three frames. Throws std::invalid_argument where the numbers of samples differ.
[[nodiscard]] double otfFlicker(std::span<const SampledCurve> otfs);

/// What the OTFs alone change in the pictures of a motion; each figure compares pictures of the same view of the same
/// phase, so the rotation's and the object's own change are not in it. RMS over pixels, colours and frames.
struct PictureFlicker {
    double change = 0.0;   ///< picture(k, otf_k) - picture(k, otf_(k-1)), from the second frame on
    double flicker = 0.0;  ///< picture(k, otf_k) - 2 picture(k, otf_(k-1)) + picture(k, otf_(k-2)), from the
                           ///< third frame on; a steady change of the OTF leaves little in it
};

/// Renders a frame's view and phase with an OTF. The result is empty only where the run was cancelled.
using FrameRenderer = std::function<std::optional<Picture>(const SweepFrame&, const SampledCurve&)>;
/// The same with any classification.
using ClassificationRenderer = std::function<std::optional<Picture>(const SweepFrame&, const Classification&)>;

/// A renderer of these frames with these settings in parallel projection, for one thread at a time. Direction and near
/// plane follow each frame's view. The scale is the same for all: the one at which the whole box is in every picture.
[[nodiscard]] FrameRenderer frameRenderer(std::span<const std::shared_ptr<const Volume>> phases,
                                          std::span<const SweepFrame> frames, const RayCastSettings& settings,
                                          const Progress& progress = {});

/// Measures the flicker of the OTFs as they are shown, one a frame; it renders up to three pictures a frame. The result
/// is empty only where the run was cancelled. Throws std::invalid_argument where the numbers of frames and OTFs differ.
/// Where all OTFs are equal nothing is rendered: equal OTFs give equal pictures.
[[nodiscard]] std::optional<PictureFlicker> pictureFlicker(std::span<const SweepFrame> frames,
                                                           std::span<const SampledCurve> otfs,
                                                           const FrameRenderer& render, const Progress& progress = {});
/// The same of any classifications.
[[nodiscard]] std::optional<PictureFlicker> pictureFlicker(std::span<const SweepFrame> frames,
                                                           std::span<const Classification> classifications,
                                                           const ClassificationRenderer& render,
                                                           const Progress& progress = {});

/// How late a smoothing shows a change, measured on an OTF that changes between equal frames.
struct SmoothingLag {
    double ramp = 0.0;  ///< frames by which a steady change is shown late
    /// Number of frames after the first changed one until a sudden change is shown to 90 %, and stays so.
    int stepToNineTenths = 0;
    /// How far beyond a sudden change the shown OTF goes before it is clamped, as a share of the change.
    double overshoot = 0.0;
};
[[nodiscard]] SmoothingLag lagOf(OtfSmoothing smoothing);

}  // namespace echolucent
