// Measures how long the GUI thread does not answer, and what is under way meanwhile.
#pragma once

#include <QList>
#include <QObject>
#include <QString>
#include <QStringList>
#include <QTimer>
#include <chrono>
#include <functional>

namespace echolucent::bench {

/// The longest time between two beats within an action, while something was under way.
struct Stall {
    QString action;    ///< what the person did: "open"
    QString underWay;  ///< at the first or the last beat: "loading"
    double milliseconds = 0.0;
    double processorMilliseconds = 0.0;  ///< of the GUI thread within it; the rest was spent waiting
    int overLimit = 0;                   ///< how many such times exceeded stallLimit
};
inline constexpr double stallLimit = 50.0;  ///< ms

/// A timer of a millisecond in the event loop of its thread. Everything in the event loop takes its turn with it,
/// paints too. So the time between two beats is the longest that a click would have had to wait.
class Heartbeat : public QObject {
public:
    /// `underWay` names what is under way now.
    explicit Heartbeat(std::function<QStringList()> underWay);

    /// From here on beats count for this action.
    void begin(const QString& action);
    void end();
    /// By action and by what was under way, in the order of their first stalls.
    [[nodiscard]] const QList<Stall>& stalls() const { return m_stalls; }

private:
    void beat();
    void count(const QString& underWay, double milliseconds, double processorMilliseconds);

    using Clock = std::chrono::steady_clock;
    std::function<QStringList()> m_underWay;
    QTimer m_timer;
    QString m_action;
    Clock::time_point m_last;
    double m_processor = 0.0;  ///< ms of the GUI thread at the last beat
    QStringList m_before;      ///< under way at the last beat
    QList<Stall> m_stalls;
};

}  // namespace echolucent::bench
