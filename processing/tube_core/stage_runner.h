// Runs the stages of the method: their threads, their stop watch, and how far they are.
#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <thread>

#include "processing/parallel.h"
#include "processing/progress.h"
#include "processing/tube_core/stage_times.h"

namespace echolucent {

/// A stage of the method.
struct Stage {
    double StageTimes::*time;
    double from, to;  ///< shares of a run's time at which the stage begins and ends, as progress counts them
};
inline constexpr Stage samplingStage{&StageTimes::sampling, 0.0, 0.6};
inline constexpr Stage interfaceFunctionStage{&StageTimes::cells, 0.6, 0.75};
inline constexpr Stage detectionStage{&StageTimes::detection, 0.75, 0.95};
inline constexpr Stage weightsStage{&StageTimes::weights, 0.95, 0.98};
inline constexpr Stage curveStage{&StageTimes::curve, 0.98, 1.0};

/// One run. It lives on the thread that asked for it; progress is reported from that thread alone and never falls.
class StageRunner {
public:
    /// Both must outlive the runner.
    StageRunner(const Progress& progress, StageTimes& times) : m_progress(progress), m_times(times) {}

    /// Ends the stage that runs, if any, and begins the next. False where the run was cancelled.
    [[nodiscard]] bool begin(const Stage& stage) {
        endStage();
        m_stage = &stage;
        return !m_progress.cancelled();
    }

    /// Ends the last stage. False where the run was cancelled.
    [[nodiscard]] bool end() {
        endStage();
        m_times.total = millisecondsSince(m_start);
        return !m_progress.cancelled();
    }

    /// Calls body(i, state) for i = 0 ... count - 1 on all threads, in any order. `state` is what makeState() gives,
    /// one for the calls that follow each other on one thread. After a cancellation the remaining calls are left out.
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

    /// `ofStage` is the share of the stage that is done, in [0,1]. Other threads report nothing, because their counts
    /// may arrive out of order.
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
