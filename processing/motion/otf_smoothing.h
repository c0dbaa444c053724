// Smoothing of OTFs over time, so that a moving picture does not flicker (Petersch 2005, sections 5 and 6.2).
#pragma once

#include <deque>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "processing/opacity_curve.h"

namespace echolucent {

/// How the shown OTF of a frame follows from its own OTF and those of the frames before it (docs/motion.md lists delays
/// and gains).
enum class OtfSmoothing {
    none,                ///< each frame has its own OTF
    mean,                ///< the mean of the newest five, the present one included
    movingLeastSquares,  ///< a polynomial of order two fitted to the newest five, at the present time; it may overshoot
    leastFlicker,        ///< weights that are never negative and give the least flicker for their delay; the default
};
/// "none", "mean", "mls", "least-flicker".
[[nodiscard]] std::string_view nameOf(OtfSmoothing smoothing);
[[nodiscard]] std::optional<OtfSmoothing> otfSmoothingFromName(std::string_view name);

/// How many frames a smoothing uses, the present one included.
[[nodiscard]] std::size_t framesUsed(OtfSmoothing smoothing);

/// How much each frame weighs in the OTF that the newest frame shows. `times` holds 1 to framesUsed() times, oldest
/// first, strictly ascending, finite, of any unit and origin. The weights are in the order of `times` and sum to 1.
/// Only those of movingLeastSquares can be negative.
///   mean                Each of n frames weighs 1/n.
///   movingLeastSquares  The newest time's row of the projection onto the polynomials of order min(2, n - 1), by QR on
///                       centred, scaled times. If times are too close to tell the powers apart, the order is lower.
///   leastFlicker        The taps of docs/motion.md, one for each whole age. A frame's age is counted in mean intervals
///                       between frames; between two ages the taps are interpolated linearly. A frame's tap is
///                       multiplied by the time that the frame stands for. All weights are divided by their sum. At
///                       equal intervals they are the newest n taps over their sum.
/// Throws std::invalid_argument if `times` breaks one of these rules.
[[nodiscard]] std::vector<double> smoothingWeights(OtfSmoothing smoothing, std::span<const double> times);

/// What weights do to a motion whose frames follow each other at equal intervals.
struct SmoothingGains {
    double delay = 0.0;        ///< mean age of the weights: frames by which a steady change is shown late
    double noise = 1.0;        ///< gain of independent noise: root of the sum of the squared weights
    double flicker = 1.0;      ///< gain of the second temporal difference of independent noise
    double leastWeight = 1.0;  ///< if below 0, opacities can overshoot and become negative
};
/// The gains of weights that are given oldest first and sum to 1.
[[nodiscard]] SmoothingGains gainsOf(std::span<const double> weights);
/// The gains of a smoothing whose history is full.
[[nodiscard]] SmoothingGains gainsOf(OtfSmoothing smoothing);

/// The unsmoothed OTFs of the frames shown so far, as many as the smoothing needs.
class OtfHistory {
public:
    explicit OtfHistory(OtfSmoothing smoothing = OtfSmoothing::leastFlicker) : m_smoothing(smoothing) {}

    [[nodiscard]] OtfSmoothing smoothing() const { return m_smoothing; }
    /// Takes the unsmoothed OTF of a new frame and returns the OTF to show. It has the same number of samples, all in
    /// [0,1]. Times have any unit and origin. A frame at the time of the newest frame replaces that frame. If all
    /// frames have equal OTFs, the shown OTF equals them to the bit. Opacities outside [0,1] are clamped, NaN counts as
    /// 0. Throws std::invalid_argument if the time descends or is not finite, or if the number of samples changes.
    [[nodiscard]] SampledCurve add(double time, const SampledCurve& unsmoothed);
    /// Forgets the past: the next frame has no history. Call it if another volume is shown or the view jumps.
    void clear() { m_frames.clear(); }

private:
    struct Frame {
        double time;
        std::vector<double> opacities;
    };
    OtfSmoothing m_smoothing;
    std::deque<Frame> m_frames;  ///< oldest first
};

}  // namespace echolucent
