// The OTFs of a motion while it plays: what every mode makes of them, row by row, and how much each flickers.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "processing/motion/motion_mode.h"
#include "processing/motion/otf_smoothing.h"

namespace echolucent {

/// The place of a frame in a motion.
struct CourseFrame {
    int angle = 0;   ///< whole degrees from the view in which the motion began, firstMotionAngle to lastMotionAngle
    int phase = 0;   ///< of the 4D study, 0 to phases - 1
    int phases = 1;  ///< of the study
};

/// Takes the unsmoothed OTF of each frame. All smoothings run side by side on the same OTFs, so that a person can look
/// at any mode and compare its flicker. Knows no widget.
class OtfCourse {
public:
    /// A step of more frames than this is a jump. Frames before and after it are not smoothed together.
    static constexpr int longestStep = 3;
    /// Flicker is measured over at most this many of the newest frames.
    static constexpr std::size_t flickerFrames = 30;

    /// The rows are angles if the probe moves, phases if only the object does.
    enum class Rows { angles, phases };

    /// Forgets everything. phases: number of rows for Rows::phases, >= 1.
    void begin(Rows rows, int phases = 1);
    /// Forgets the past of the smoothing. The rows stay.
    void forgetPast();
    /// Adds a frame with its own OTF. The same frame again replaces the last one. A jump forgets the past.
    void add(const CourseFrame& frame, const SampledCurve& unsmoothed);
    /// Adds a frame that shows the one OTF of the motion.
    void addOneOtf(const CourseFrame& frame, const SampledCurve& curve);

    /// The curve of a mode for the last frame; empty before the first.
    [[nodiscard]] const SampledCurve& newest(MotionOtf mode) const { return m_newest[indexOf(mode)]; }
    /// otfFlicker() of the newest frames in a mode. No value before the third frame since the last jump. The one OTF
    /// has a flicker of 0 as soon as there is a curve.
    [[nodiscard]] std::optional<double> flicker(MotionOtf mode) const;

    [[nodiscard]] Rows rows() const { return m_rows; }
    [[nodiscard]] int rowCount() const { return static_cast<int>(m_curves.size()); }
    /// The number of a row: degrees, or the phase counted from 1.
    [[nodiscard]] int numberOf(int row) const;
    [[nodiscard]] int rowOf(const CourseFrame& frame) const;
    /// The curve of a row in a mode; null if no such frame came yet.
    [[nodiscard]] const SampledCurve* curve(int row, MotionOtf mode) const;
    /// The row of the last frame.
    [[nodiscard]] std::optional<int> presentRow() const { return m_presentRow; }

private:
    using Curves = std::array<SampledCurve, allMotionOtfs.size()>;
    [[nodiscard]] static constexpr std::size_t indexOf(MotionOtf mode) { return static_cast<std::size_t>(mode); }
    void keep(const CourseFrame& frame, MotionOtf mode, const SampledCurve& curve);

    Rows m_rows = Rows::angles;
    std::vector<Curves> m_curves = std::vector<Curves>(lastMotionAngle - firstMotionAngle + 1);
    Curves m_newest;
    std::array<OtfHistory, 4> m_histories{OtfHistory(OtfSmoothing::none), OtfHistory(OtfSmoothing::mean),
                                          OtfHistory(OtfSmoothing::movingLeastSquares),
                                          OtfHistory(OtfSmoothing::leastFlicker)};
    std::array<std::vector<SampledCurve>, allMotionOtfs.size()> m_recent;  // since the last jump, oldest first
    std::optional<CourseFrame> m_last;
    std::optional<int> m_presentRow;
    double m_time = 0.0;  // counted in frames
};

}  // namespace echolucent
