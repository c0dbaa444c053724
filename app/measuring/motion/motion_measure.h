// The measures of `study motion` on one motion.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "processing/motion/flicker.h"
#include "processing/motion/otf_sweep.h"

namespace echolucent::cli {

/// One motion of one study.
struct MotionCase {
    std::string name;   ///< name in files, as "fetus_both"
    std::string title;  ///< name for people, as "Simulated fetus, probe and object move"
    std::vector<std::shared_ptr<const Volume>> phases;
    Viewpoint start;
    Motion motion;
    bool stills = false;  ///< whether the page shows pictures of it
};

/// How the OTFs of the frames are chosen: by a smoothing. If there is none, all frames have the OTF of the start view.
using MotionMode = std::optional<OtfSmoothing>;
/// The modes static, none, mean, mls and least-flicker.
[[nodiscard]] std::vector<MotionMode> motionModes();
[[nodiscard]] std::string nameOf(const MotionMode& mode);

/// The course of the OTFs in one mode.
struct ModeFigures {
    MotionMode mode;
    std::vector<SampledCurve> shown;
    double otfFlicker = 0.0;
    PictureFlicker pictures;
    double lowest = 0.0, highest = 0.0;  ///< opacities before they are clamped to [0,1]
};

/// How far apart the OTFs of two frames are, and the pictures of the middle frame that are made with these OTFs.
struct CurveDifference {
    std::string name;  ///< name of the pair of frames, as "-45 and 0 degrees"
    double rms = 0.0, largest = 0.0, pictureRms = 0.0;
};

/// The flicker after leastFlicker, if another quantity than opacity is smoothed: as a share of the unsmoothed flicker.
struct DomainFigures {
    double opacity = 0.0, logarithm = 0.0, extinction = 0.0;
};

struct Still {
    std::string caption;
    Picture picture;
};

struct MotionFigures {
    MotionCase motionCase;
    std::vector<SweptOtf> frames;    ///< unsmoothed
    SampledCurve initial, oneOtf;    ///< the initial function; the OTF of the start view and first phase
    std::vector<ModeFigures> modes;  ///< in the order of motionModes()
    std::vector<CurveDifference> differences;
    double adaptation = 0.0;         ///< RMS difference between oneOtf and the initial function, to compare with
    double adaptationPicture = 0.0;  ///< RMS difference of the middle frame's pictures made with these two
    /// RMS over pixels and frames between pictures with oneOtf and with each frame's OTF, and the largest RMS of one
    /// frame.
    double staticPictureRms = 0.0, worstStaticPictureRms = 0.0;
    DomainFigures domains;
    std::vector<Still> stills;
};

/// Root of the mean squared difference between two OTFs, over intensities.
[[nodiscard]] double rmsBetween(const SampledCurve& one, const SampledCurve& other);

/// Compares square pictures of `edge` pixels an edge. The stills have `stillEdge` pixels an edge.
[[nodiscard]] MotionFigures measureMotion(const MotionCase& motionCase, const AdaptiveOtfConfig& config, int edge,
                                          int stillEdge);

}  // namespace echolucent::cli
