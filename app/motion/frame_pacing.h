// When the next frame of a motion is due, so that a late frame makes none of those after it late.
#pragma once

#include <algorithm>
#include <chrono>

namespace echolucent {

/// Frames are due at even intervals. One that is late by less than an interval is followed by a shorter wait, so that
/// the motion keeps its speed; what is later than that is given up, so that a motion that was held up does not hurry
/// afterwards. Knows no clock: times count from any fixed moment.
class FramePacing {
public:
    using Time = std::chrono::nanoseconds;

    /// Playing begins, or goes on after a pause, at `now`. It is never ahead of the frame before.
    void resume(Time now, Time interval) { m_due = std::max(m_due, now - interval); }
    /// A frame is begun at `now`. Intervals are not negative.
    void begin(Time now, Time interval) { m_due = std::clamp(m_due + interval, now - interval, now); }
    /// How long to wait for the next frame; 0 where it is due.
    [[nodiscard]] Time wait(Time now, Time interval) const { return std::max(Time{0}, m_due + interval - now); }

private:
    Time m_due = std::chrono::hours(-24 * 365);  ///< when the newest frame was due
};

}  // namespace echolucent
