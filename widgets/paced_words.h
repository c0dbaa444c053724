// Limits how often texts of panels change while a motion plays.
#pragma once

#include <QTimer>
#include <functional>
#include <utility>

namespace echolucent {

/// New texts lay out a panel anew, which can take as long as drawing a picture. Nobody reads more than one in
/// `milliseconds`. The last text is always told, at most that much later.
class PacedWords {
public:
    /// `tell` shows the present facts in the panel.
    explicit PacedWords(std::function<void()> tell) : m_tell(std::move(tell)) {
        m_timer.setSingleShot(true);
        m_timer.setInterval(milliseconds);
        QObject::connect(&m_timer, &QTimer::timeout, &m_timer, [this] {
            if (m_waiting) tellNow();
        });
    }
    /// Tells at once, or, if less than `milliseconds` have passed since the last time, as soon as they have passed.
    void tell() {
        m_waiting = true;
        if (!m_timer.isActive()) tellNow();
    }
    void tellNow() {
        m_waiting = false;
        m_timer.start();
        m_tell();
    }
    static constexpr int milliseconds = 250;

private:
    std::function<void()> m_tell;
    QTimer m_timer;
    bool m_waiting = false;
};

}  // namespace echolucent
