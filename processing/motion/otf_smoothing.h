// Smoothing of OTFs over time, so that a moving picture does not flicker (Petersch 2005, sections 5 and 6.2).
#pragma once

#include <deque>
#include <optional>
#include <string_view>
#include <vector>

#include "processing/opacity_curve.h"

namespace echolucent {

/// How the OTF of a frame follows from those of the frames before. Delay and gains: docs/motion.md.
enum class OtfSmoothing {
    none,                ///< each frame its own OTF
    mean,                ///< mean of the newest five, the present one included
    movingLeastSquares,  ///< polynomial of order two through the newest five, taken at the present time: may overshoot
    leastFlicker,        ///< weights that are never negative and give the least flicker for their delay: the default
};
/// "none", "mean", "mls", "least-flicker".
[[nodiscard]] std::string_view nameOf(OtfSmoothing smoothing);
[[nodiscard]] std::optional<OtfSmoothing> otfSmoothingFromName(std::string_view name);

/// The unsmoothed OTFs of the frames shown so far, as many as the smoothing needs.
class OtfHistory {
public:
    explicit OtfHistory(OtfSmoothing smoothing = OtfSmoothing::leastFlicker) : m_smoothing(smoothing) {}

    [[nodiscard]] OtfSmoothing smoothing() const { return m_smoothing; }
    /// Takes the unsmoothed OTF of a new frame and returns the one to show: opacities in [0,1], as many samples as
    /// `unsmoothed`. time: of any unit and origin, never descending; a frame at the time of the newest one replaces it.
    /// Throws std::invalid_argument where time descends or is not finite, or the number of samples changes.
    [[nodiscard]] SampledCurve add(double time, const SampledCurve& unsmoothed);
    /// Forgets the past: the next frame has no history (another volume, a jump of the view).
    void clear() { m_frames.clear(); }

private:
    struct Frame {
        double time;
        std::vector<double> opacities;
    };
    OtfSmoothing m_smoothing;
    std::deque<Frame> m_frames;  // oldest first
};

}  // namespace echolucent
