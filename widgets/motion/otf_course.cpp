#include "widgets/motion/otf_course.h"

#include <algorithm>
#include <cstdlib>

#include "processing/motion/flicker.h"

namespace echolucent {
namespace {

/// The modes of OtfCourse::m_histories, in their order.
constexpr std::array modesWithHistory{MotionOtf::eachView, MotionOtf::mean, MotionOtf::movingLeastSquares,
                                      MotionOtf::leastFlicker};

/// Number of frames from one frame to another. The phases repeat in a circle.
int stepBetween(const CourseFrame& a, const CourseFrame& b) {
    const int phases = std::abs(a.phase - b.phase);
    return std::max(std::abs(a.angle - b.angle), std::min(phases, b.phases - phases));
}

}  // namespace

void OtfCourse::begin(Rows rows, int phases) {
    m_rows = rows;
    const int count = rows == Rows::phases ? phases : lastMotionAngle - firstMotionAngle + 1;
    m_curves.assign(static_cast<std::size_t>(count), Curves{});
    m_newest = {};
    m_presentRow.reset();
    forgetPast();
}

void OtfCourse::forgetPast() {
    for (OtfHistory& history : m_histories) history.clear();
    for (auto& recent : m_recent) recent.clear();
    m_last.reset();
    m_time = 0.0;
}

void OtfCourse::add(const CourseFrame& frame, const SampledCurve& unsmoothed) {
    const int step = m_last ? stepBetween(*m_last, frame) : 0;
    if (step > longestStep) forgetPast();
    const bool again = m_last && step == 0;
    if (m_last) m_time += step;
    m_last = frame;
    for (std::size_t i = 0; i < m_histories.size(); ++i) {
        const MotionOtf mode = modesWithHistory[i];
        keep(frame, mode, m_histories[i].add(m_time, unsmoothed));
        auto& recent = m_recent[indexOf(mode)];
        if (again && !recent.empty()) recent.pop_back();
        recent.push_back(newest(mode));
        if (recent.size() > flickerFrames) recent.erase(recent.begin());
    }
}

void OtfCourse::addOneOtf(const CourseFrame& frame, const SampledCurve& curve) {
    keep(frame, MotionOtf::oneOtf, curve);
}

void OtfCourse::keep(const CourseFrame& frame, MotionOtf mode, const SampledCurve& curve) {
    m_newest[indexOf(mode)] = curve;
    m_presentRow = rowOf(frame);
    m_curves[static_cast<std::size_t>(*m_presentRow)][indexOf(mode)] = curve;
}

std::optional<double> OtfCourse::flicker(MotionOtf mode) const {
    if (mode == MotionOtf::oneOtf) return newest(mode).opacities.empty() ? std::nullopt : std::optional(0.0);
    const auto& recent = m_recent[indexOf(mode)];
    if (recent.size() < 3) return std::nullopt;
    return otfFlicker(recent);
}

int OtfCourse::numberOf(int row) const { return m_rows == Rows::phases ? row + 1 : firstMotionAngle + row; }

int OtfCourse::rowOf(const CourseFrame& frame) const {
    const int row = m_rows == Rows::phases ? frame.phase : frame.angle - firstMotionAngle;
    return std::clamp(row, 0, rowCount() - 1);
}

const SampledCurve* OtfCourse::curve(int row, MotionOtf mode) const {
    if (row < 0 || row >= rowCount()) return nullptr;
    const SampledCurve& curve = m_curves[static_cast<std::size_t>(row)][indexOf(mode)];
    return curve.opacities.empty() ? nullptr : &curve;
}

}  // namespace echolucent
