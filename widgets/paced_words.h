// How often words change in the panels while pictures follow each other.
#pragma once

#include <QTimer>
#include <functional>
#include <utility>

namespace echolucent {

/// New words lay a panel out anew, which can take as long as drawing a picture, and nobody reads more of them than one
/// every `milliseconds`. The last words are always told, that much later at most.
class PacedWords {
public:
    /// `tell` brings what is true when it is called into the panel.
    explicit PacedWords(std::function<void()> tell) : m_tell(std::move(tell)) {
        m_timer.setSingleShot(true);
        m_timer.setInterval(milliseconds);
        QObject::connect(&m_timer, &QTimer::timeout, &m_timer, [this] {
            if (m_waiting) tellNow();
        });
    }
    /// Tells at once, or where that was done less than `milliseconds` ago, when they have gone by.
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
