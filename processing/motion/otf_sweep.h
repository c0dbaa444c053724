// The OTFs of a moving transducer, a moving object, or both (Petersch 2005, section 5).
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "processing/adaptive/adaptive_otf_config.h"
#include "processing/adaptive/quiet_reading.h"
#include "processing/motion/motion_mode.h"
#include "processing/motion/otf_smoothing.h"
#include "processing/opacity_curve.h"
#include "processing/progress.h"
#include "processing/viewpoint/viewpoint.h"
#include "processing/volume/volume.h"

namespace echolucent {

/// The view turned by an angle from the view in which a motion began.
[[nodiscard]] Viewpoint turned(const Viewpoint& start, MotionAxis axis, double degrees);

/// One frame of a motion.
struct SweepFrame {
    double time = 0.0;     ///< number of frames since the first
    double degrees = 0.0;  ///< angle from the first view
    int phase = 0;         ///< phase of the 4D study, from 0
    Viewpoint view;
};

/// A frame and its OTFs.
struct SweptOtf {
    SweepFrame frame;
    SampledCurve unsmoothed;
    SampledCurve shown;       ///< after smoothing
    double sumOfD = 0.0;      ///< sum of d over the unsmoothed OTF's tube cores
    int tubesWithWeight = 0;  ///< tube cores of the unsmoothed OTF that have a weight
};

/// The frames alone.
[[nodiscard]] std::vector<SweepFrame> framesOf(std::span<const SweptOtf> swept);

/// The frames of a probe that turns from `from` to `to` degrees in steps; where there are several phases, the object
/// moves by one phase a frame, over and over. `to` below `from` turns backwards; `to` itself is a frame where the range
/// is a whole number of steps. Throws std::invalid_argument for angles that are not finite, a step not above 0, no
/// phase, or more than a million frames.
[[nodiscard]] std::vector<SweepFrame> sweepFrames(const Viewpoint& start, MotionAxis axis, double from, double to,
                                                  double step, int phases);

/// What moves, for as many frames as the angles have steps: the three scenarios of Petersch 2005, section 5.
struct Motion {
    MotionAxis axis = MotionAxis::y;
    double from = firstMotionAngle, to = lastMotionAngle, step = 1.0;  ///< degrees, as for sweepFrames()
    bool probeMoves = true;    ///< where false, every frame has the first view at 0 degrees
    bool objectMoves = false;  ///< whether phases follow each other; where false, firstPhase stays
    int firstPhase = 0;
};
/// The frames of a motion in a study of `phases` phases. Throws std::invalid_argument as sweepFrames() does, and where
/// firstPhase is not one of them.
[[nodiscard]] std::vector<SweepFrame> motionFrames(const Viewpoint& start, const Motion& motion, int phases);

/// Computes every frame's OTF; `phases` are the volumes of the study. `shown`, by phase, are the voxels that the OTFs
/// are meant for; if it is empty, those of `phases` are. The result is empty only where the run was cancelled. Frames
/// are computed side by side, with the same bits for any number of threads. Frames of one phase and view are computed
/// once; a roll turns the grid of tube cores with the picture and is another view. The smoothing runs in frame order
/// afterwards, so frame times must not descend. Throws std::invalid_argument where a phase is not there, `shown` holds
/// another number of phases, or problemOf(config) is not empty.
[[nodiscard]] std::optional<std::vector<SweptOtf>> sweepOtfs(std::span<const std::shared_ptr<const Volume>> phases,
                                                             std::span<const SweepFrame> frames,
                                                             const AdaptiveOtfConfig& config, OtfSmoothing smoothing,
                                                             const Progress& progress = {},
                                                             std::span<const QuietVoxels> shown = {});

}  // namespace echolucent
