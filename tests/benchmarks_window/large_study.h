// A person opens a large volume in the real window and cuts it, while a heartbeat listens.
#pragma once

#include "tests/benchmarks_window/heartbeat.h"
#include "tests/benchmarks_window/open_window.h"

namespace echolucent::bench {

/// The window as it starts, with the simulated scan, all four panes visible and a picture of which OpenGL's start is a
/// part that counts nowhere.
class LargeStudy : private OpenWindow {
public:
    LargeStudy();

    /// The window is shown and rests; a volume is opened, its case report is made, it is cut flat and by the scalpel,
    /// its session is saved with twenty snapshots, the stroke is undone, and the simulated scan takes its place. Each
    /// action lasts until its picture is converged.
    [[nodiscard]] QList<Stall> stalls(const QString& volume);
    /// From opening the volume to its checksum, beside all else that opening begins.
    [[nodiscard]] double checksumMilliseconds() const { return m_checksumMilliseconds; }

private:
    [[nodiscard]] QStringList underWay();

    double m_checksumMilliseconds = 0;
};

}  // namespace echolucent::bench
