// Cuts a study's phases by the scalpel's strokes, in a thread of its own, and keeps the result.
#pragma once

#include <QObject>
#include <QString>
#include <memory>
#include <utility>
#include <vector>

#include "processing/scalpel/scalpel_cuts.h"
#include "processing/volume/volume.h"
#include "widgets/threads/newest_wins_thread.h"

namespace echolucent {

/// Cuts the wanted phase first and then the others. Call it in the thread it lives in; it sends its signals there too.
class CutPhases : public QObject {
    Q_OBJECT

public:
    using Phases = std::vector<std::shared_ptr<const Volume>>;

    explicit CutPhases(Works& works, QObject* parent = nullptr);

    /// Takes the phases of another study; nothing of them is cut.
    void begin(Phases scans);
    /// Wants a phase (counted from 0) with these strokes. New strokes replace those that are being cut; until the new
    /// cut is made, the earlier one is shown. Without strokes nothing is cut, at once.
    void want(int phase, const std::vector<ScalpelStroke>& strokes);

    /// The voxels of a phase, raw or quiet, without what is cut of them so far. The result is the same object as long
    /// as neither voxels nor cut change. If nothing is cut, it is `voxels` itself.
    [[nodiscard]] std::shared_ptr<const Volume> of(int phase, const std::shared_ptr<const Volume>& voxels);
    [[nodiscard]] const std::vector<ScalpelStroke>& strokes() const { return m_strokes; }
    /// Whether the cut of a phase is that of the strokes.
    [[nodiscard]] bool isCurrent(int phase) const { return m_cut.at(static_cast<std::size_t>(phase)).current; }
    [[nodiscard]] bool busy() const { return m_thread.busy(); }

signals:
    /// The cut of a phase has changed.
    void made(int phase);
    /// There is not enough memory: the earlier cut of each phase stays until other strokes are wanted.
    void failed(const QString& sentence);
    void busyChanged(bool busy);

private:
    [[nodiscard]] int next() const;
    void makeNext();

    /// A phase's mask, and the volumes made with it, newest first. Each pair is the voxels and their cut volume.
    struct Cut {
        Volume::SharedMask mask;  ///< null if nothing is cut
        bool current = true;      ///< whether it is that of the strokes
        std::vector<std::pair<std::shared_ptr<const Volume>, std::shared_ptr<const Volume>>> volumes{};
    };
    void take(int phase, Volume::SharedMask mask);

    Phases m_scans;
    std::vector<Cut> m_cut;
    std::vector<ScalpelStroke> m_strokes;
    std::shared_ptr<ScalpelCuts> m_cuts;  ///< used by the thread alone; null before the first stroke
    int m_wanted = 0;
    // Last, so that its thread has ended before anything above is destroyed.
    NewestWinsThread m_thread;
};

}  // namespace echolucent
