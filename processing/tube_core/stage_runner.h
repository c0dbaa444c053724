// Runs the stages of the method: their threads, their times, and their progress.
#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <thread>

#include "processing/parallel.h"
#include "processing/progress.h"
#include "processing/tube_core/stage_times.h"

namespace echolucent {

struct Stage {
    double StageTimes::*time;
    double from, to;  ///< shares of a run's time, for progress: where the stage begins and ends
};
inline constexpr Stage samplingStage{&StageTimes::sampling, 0.0, 0.6};
inline constexpr Stage interfaceFunctionStage{&StageTimes::cells, 0.6, 0.75};
inline constexpr Stage detectionStage{&StageTimes::detection, 0.75, 0.95};
inline constexpr Stage weightsStage{&StageTimes::weights, 0.95, 0.98};
inline constexpr Stage curveStage{&StageTimes::curve, 0.98, 1.0};

/// One run, used by the thread that asked for it. Only that thread reports progress, which never falls.
class StageRunner {
public:
    /// Both must outlive the runner.
    StageRunner(const Progress& progress, StageTimes& times) : m_progress(progress), m_times(times) {}

    /// Ends the stage that runs, if any, and begins the next. False if the run was cancelled.
    [[nodiscard]] bool begin(const Stage& stage) {
        endStage();
        m_stage = &stage;
        return !m_progress.cancelled();
    }

    /// Ends the last stage. False if the run was cancelled.
    [[nodiscard]] bool end() {
        endStage();
        m_times.total = millisecondsSince(m_start);
        return !m_progress.cancelled();
    }

    /// Calls body(i, state) for i = 0 ... count - 1 on all threads, in any order. makeState() makes the `state`, one
    /// for each series of calls on one thread. A cancelled run leaves out the remaining calls.
    template <typename MakeState, typename Body>
    void forEach(std::size_t count, const MakeState& makeState, const Body& body) {
        std::atomic<std::size_t> done = 0;
        parallelFor(LoopRange<std::size_t>(0, count), [&](const LoopRange<std::size_t>& range) {
            auto state = makeState();
            for (std::size_t i = range.begin(); i < range.end() && !m_progress.cancelled(); ++i) {
                body(i, state);
                if (m_progress.report) reportShare(static_cast<double>(++done) / static_cast<double>(count));
            }
        });
    }

private:
    using Clock = std::chrono::steady_clock;

    static double millisecondsSince(Clock::time_point start) {
        return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
    }

    void endStage() {
        if (m_stage != nullptr) {
            m_times.*(m_stage->time) = millisecondsSince(m_stageStart);
            if (m_progress.report && !m_progress.cancelled()) reportShare(1.0);
        }
        m_stage = nullptr;
        m_stageStart = Clock::now();
    }

    /// `ofStage` is the finished share of the stage, in [0,1]. Only the thread that made the runner reports, because
    /// the counts of other threads may arrive out of order.
    void reportShare(double ofStage) {
        if (std::this_thread::get_id() == m_caller)
            m_progress.at(ofStage < 1.0 ? m_stage->from + ofStage * (m_stage->to - m_stage->from) : m_stage->to);
    }

    const Progress& m_progress;
    StageTimes& m_times;
    const std::thread::id m_caller = std::this_thread::get_id();
    const Clock::time_point m_start = Clock::now();
    Clock::time_point m_stageStart = m_start;
    const Stage* m_stage = nullptr;
};

}  // namespace echolucent
