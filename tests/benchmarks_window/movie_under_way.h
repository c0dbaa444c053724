// Writes a movie in the real window while a heartbeat listens.
#pragma once

#include <QSize>

#include "tests/benchmarks_window/heartbeat.h"
#include "tests/benchmarks_window/open_window.h"

namespace echolucent::bench {

struct MovieCost {
    QString ending;  ///< of its file's name
    int frames = 0;
    double seconds = 0.0;
};

/// The window with a 4D study. Its phases move, each with its own OTF, quiet and lit as a study is opened.
class MovieUnderWay : private OpenWindow {
public:
    explicit MovieUnderWay(const QString& volume);

    /// Lets the window rest. Stalls after that come from the machine.
    void rest();
    /// Writes a movie of all phases, of `size` pixels, into a file of its own. The first movie loads the encoder.
    [[nodiscard]] MovieCost write(const QString& ending, const QSize& size);
    /// The stalls so far.
    [[nodiscard]] const QList<Stall>& stalls() const { return m_heartbeat.stalls(); }

private:
    QTemporaryDir m_out;
    Heartbeat m_heartbeat;
};

}  // namespace echolucent::bench
