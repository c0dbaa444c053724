// When the next frame of a motion is due. A late frame does not delay those after it.
#pragma once

#include <algorithm>
#include <chrono>

namespace echolucent {

/// A frame is due an interval after the one before it. If it is late, the next wait is shorter by that delay, at most
/// by one interval, so the motion keeps its speed. What goes beyond an interval is given up, so a motion that was held
/// up does not hurry for long. This class has no clock: times count from any fixed moment.
class FramePacing {
public:
    using Time = std::chrono::nanoseconds;

    /// Playing begins, or goes on after a pause, at `now`. The interval of the frame before still holds.
    void resume(Time now, Time interval) { m_due = std::max(m_due, now - interval); }
    /// A frame is begun at `now`. `interval` is that of the frame before. Intervals are not negative.
    void begin(Time now, Time interval) { m_due = std::clamp(m_due + interval, now - interval, now); }
    /// How long to wait until the frame that was begun has been shown for `interval`; 0 if it has.
    [[nodiscard]] Time wait(Time now, Time interval) const { return std::max(Time{0}, m_due + interval - now); }

private:
    Time m_due = std::chrono::hours(-24 * 365);  ///< when the newest frame was due
};

}  // namespace echolucent
