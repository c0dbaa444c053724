// Opens a large volume in the real window and cuts it, as a person would, while a heartbeat listens.
#pragma once

#include "tests/benchmarks_window/heartbeat.h"
#include "tests/benchmarks_window/open_window.h"

namespace echolucent::bench {

/// The window as it starts, with the simulated scan, all four panes visible and a first picture. That picture includes
/// OpenGL's start and counts nowhere.
class LargeStudy : private OpenWindow {
public:
    LargeStudy();

    /// Shows the window and lets it rest. Opens a volume, makes its case report, cuts it flat and by the scalpel, saves
    /// its session with twenty snapshots, undoes the stroke, and goes back to the simulated scan. Each action lasts
    /// until its picture is converged.
    [[nodiscard]] QList<Stall> stalls(const QString& volume);
    /// From opening the volume to its checksum, beside everything else that opening begins.
    [[nodiscard]] double checksumMilliseconds() const { return m_checksumMilliseconds; }

private:
    [[nodiscard]] QStringList underWay();

    double m_checksumMilliseconds = 0;
};

}  // namespace echolucent::bench
