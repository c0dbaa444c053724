// How often words change in the panels while pictures follow each other.
#pragma once

#include <QElapsedTimer>

namespace echolucent {

/// New words lay a panel out anew, which can take as long as drawing a picture, and nobody reads more of them than
/// these. Whoever asks sees to it that the last words are shown when the pictures rest.
class Pace {
public:
    /// Whether words are due: the first time, and then once `milliseconds` have gone by since they were due last.
    [[nodiscard]] bool due() {
        if (m_sinceDue.isValid() && m_sinceDue.elapsed() < milliseconds) return false;
        m_sinceDue.start();
        return true;
    }
    static constexpr int milliseconds = 250;

private:
    QElapsedTimer m_sinceDue;
};

}  // namespace echolucent
