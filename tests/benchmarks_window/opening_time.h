// Measures how soon a large volume is seen in the real window.
#pragma once

#include <QList>
#include <optional>

#include "tests/benchmarks_window/open_window.h"

namespace echolucent::bench {

/// Milliseconds from asking for a volume, medians of several openings.
struct OpeningTimes {
    double plainRead = 0;                 ///< reading all bytes of the file in this process
    double dimmed = 0;                    ///< the old picture is dimmed on the screen
    std::optional<double> coarsePainted;  ///< the coarse picture is painted; no value if there was none
    double opened = 0;                    ///< the study is read and its finds are made
    double firstPicture = 0;              ///< a picture of all voxels is on the screen
    double allRays = 0;                   ///< a picture with a ray for each pixel is on the screen
    double converged = 0;
};

/// The window at 1280 x 720, as it starts, with the simulated scan. A reader process waits, as in the program.
class OpeningTime : private OpenWindow {
public:
    OpeningTime();

    /// Opens the volume `runs` times, each time after the simulated scan. The file is in the page cache.
    [[nodiscard]] OpeningTimes measure(const QString& volume, int runs);

private:
    void rest() const;
};

/// A table of one line, with the times as multiples of the plain read.
[[nodiscard]] QString openingTable(const OpeningTimes& times);

}  // namespace echolucent::bench
