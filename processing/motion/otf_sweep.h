// The OTFs of a moving transducer, a moving object, or both (Petersch 2005, section 5).
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "processing/adaptive/adaptive_otf_config.h"
#include "processing/adaptive/adaptive_otf_result.h"
#include "processing/motion/motion_mode.h"
#include "processing/motion/otf_smoothing.h"
#include "processing/opacity_curve.h"
#include "processing/progress.h"
#include "processing/viewpoint/viewpoint.h"
#include "processing/volume/volume.h"

namespace echolucent {

/// The view turned by an angle from the view in which a motion began. Front and box stay in place in the volume. About
/// the screen's vertical it has the bits of y if `start` has neither elevation nor roll, about the screen's horizontal
/// those of x if it has no roll, and in the picture's plane always those of z.
[[nodiscard]] Viewpoint turned(const Viewpoint& start, MotionAxis axis, double degrees);

struct SweepFrame {
    double time = 0.0;     ///< number of frames since the first
    double degrees = 0.0;  ///< angle from the view in which the motion began
    int phase = 0;         ///< phase of the 4D study, from 0
    Viewpoint view;
};

struct SweptOtf {
    SweepFrame frame;
    SampledCurve unsmoothed;
    SampledCurve shown;          ///< after smoothing
    double sumOfD = 0.0;         ///< sum of d over the unsmoothed OTF's tube cores
    int tubesMeetingVolume = 0;  ///< tube cores of the unsmoothed OTF that meet data
    int tubesWithWeight = 0;     ///< those of them that have a weight
};

[[nodiscard]] std::vector<SweepFrame> framesOf(std::span<const SweptOtf> swept);

/// The frames of a probe that turns from `from` to `to` degrees in steps. If `to` is below `from`, it turns backwards.
/// `to` itself is a frame if the range is a whole number of steps. With several phases the object moves by one phase a
/// frame, from phase 0 on, over and over. Throws std::invalid_argument for angles that are not finite, a step not above
/// 0, no phase, or more than a million frames.
[[nodiscard]] std::vector<SweepFrame> sweepFrames(const Viewpoint& start, MotionAxis axis, double from, double to,
                                                  double step, int phases);

/// What moves: one of the three scenarios of Petersch 2005, section 5. There is a frame for each step of the angle,
/// also if the probe does not move.
struct Motion {
    MotionAxis axis = MotionAxis::screenVertical;
    double from = firstMotionAngle, to = lastMotionAngle, step = 1.0;  ///< degrees, as for sweepFrames()
    bool probeMoves = true;    ///< if false, every frame has the view `start`, at 0 degrees
    bool objectMoves = false;  ///< if false, every frame has firstPhase; if true, the first frame has it
    int firstPhase = 0;
};
/// The frames of a motion in a study of `phases` phases. Throws std::invalid_argument as sweepFrames() does, and if the
/// study has no firstPhase.
[[nodiscard]] std::vector<SweepFrame> motionFrames(const Viewpoint& start, const Motion& motion, int phases);

/// Computes the OTF of a frame. Several threads call it at once. The result is empty only if progress.cancel was
/// raised.
using FrameOtf = std::function<std::optional<AdaptiveOtf>(const SweepFrame& frame, const Progress& progress)>;

/// Computes every frame's OTF by `otfOf`. The result is empty only if the work was cancelled.
///
/// Frames are computed side by side; the bits are the same for any number of threads. Frames of one phase and view are
/// computed once. (Frames whose views differ in nothing but box or front may be computed again.) A roll is
/// another view, because it turns the grid of tube cores with the picture. Smoothing runs afterwards in frame order.
/// Throws std::invalid_argument if a frame's time descends or is not finite.
[[nodiscard]] std::optional<std::vector<SweptOtf>> sweepOtfs(std::span<const SweepFrame> frames, const FrameOtf& otfOf,
                                                             OtfSmoothing smoothing, const Progress& progress = {});
/// The same for the adaptive OTFs of `phases`, the volumes of the study, along each frame's view. Also throws
/// std::invalid_argument if a frame's phase is missing or problemOf(config) is not empty.
[[nodiscard]] std::optional<std::vector<SweptOtf>> sweepOtfs(std::span<const std::shared_ptr<const Volume>> phases,
                                                             std::span<const SweepFrame> frames,
                                                             const AdaptiveOtfConfig& config, OtfSmoothing smoothing,
                                                             const Progress& progress = {});

}  // namespace echolucent
