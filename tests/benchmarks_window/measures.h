// Counts pictures that follow each other.
#pragma once

#include <QElapsedTimer>
#include <QString>
#include <ctime>
#include <vector>

#include "widgets/volume_view/volume_view_widget.h"

namespace echolucent::bench {

/// How much of each action is measured.
struct Amount {
    double seconds = 4.0;
    int frames = 0;  ///< if above 0, this many frames are measured, however long they take
    int views = 20;  ///< number of jumps to a high-quality picture
};

/// One line of the table: an action in a window, and its measures.
struct Row {
    /// "orbit", "edit", "light", "high quality", "edit in document", "undo in document", "first turn", "later turns",
    /// "from memory", "explain" or "grow" (TubeCoresUnderTest); with all four panes "reference", "box" or "orbit in
    /// quad".
    QString action;
    QString curve;
    int edge = 0;  ///< edge of the picture, device pixels
    bool shaded = false;
    double framesPerSecond = 0.0;  ///< pictures drawn a second; "high quality" and "in document": 1 / median time from
                                   ///< change to picture; with all four panes: updates (RoomUnderTest)
    double deliveredPerSecond = 0.0;
    double medianInterval = 0.0, interval95 = 0.0;  ///< ms between pictures on the screen; for "high quality" and "in
                                                    ///< document" the times
    double castMilliseconds = 0.0, drawMilliseconds = 0.0;  ///< medians
    QString quality;                                        ///< the most frequent one
    QSize rays;
    double step = 0.0;
    double qualityShare = 0.0;    ///< share of the pictures that had this quality, at these rays and this step
    double processorShare = 0.0;  ///< processor time of this program over wall time times processors
    int frames = 0;
};

/// Median or another quantile of values; 0 if there are none.
[[nodiscard]] double quantile(std::vector<double> values, double share);

/// Wall and processor time since its start.
class Stopwatch {
public:
    void start();
    [[nodiscard]] double milliseconds() const;
    [[nodiscard]] double processorShare() const;

private:
    QElapsedTimer m_wall;
    std::clock_t m_processor = 0;
};

/// The pictures of one measurement, in the order in which they came.
class FrameRecord {
public:
    /// Forgets the pictures so far.
    void begin();
    void delivered(const PictureReport& report) { m_reports.push_back(report); }
    void drawn() { m_drawn.push_back(m_clock.milliseconds()); }
    [[nodiscard]] int drawnFrames() const { return static_cast<int>(m_drawn.size()); }
    [[nodiscard]] double milliseconds() const { return m_clock.milliseconds(); }
    /// Fills in what follows from the pictures.
    void summarise(Row& row) const;

private:
    Stopwatch m_clock;
    std::vector<PictureReport> m_reports;
    std::vector<double> m_drawn;  // ms
};

}  // namespace echolucent::bench
