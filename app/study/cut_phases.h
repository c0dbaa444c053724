// What the scalpel's strokes leave of a study's phases: cut in a thread of its own, and kept.
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

/// Cuts the phase that is wanted first and then the others. All of it is to be called, and every signal is sent, in the
/// thread this lives in.
class CutPhases : public QObject {
    Q_OBJECT

public:
    using Phases = std::vector<std::shared_ptr<const Volume>>;

    explicit CutPhases(Works& works, QObject* parent = nullptr);

    /// Another study is open, of which nothing is cut.
    void begin(Phases scans);
    /// Wants a phase (counted from 0) with these strokes. Other strokes than before replace those that are being cut;
    /// what was cut before them is shown until they are. No stroke at all cuts nothing, at once.
    void want(int phase, const std::vector<ScalpelStroke>& strokes);

    /// Voxels of a phase, raw or quiet, with what is cut of them so far: the same object as long as neither changes,
    /// and the voxels themselves where nothing is cut.
    [[nodiscard]] std::shared_ptr<const Volume> of(int phase, const std::shared_ptr<const Volume>& voxels);
    [[nodiscard]] const std::vector<ScalpelStroke>& strokes() const { return m_strokes; }
    /// Whether what is cut of a phase is what the strokes say.
    [[nodiscard]] bool isCurrent(int phase) const { return m_cut.at(static_cast<std::size_t>(phase)).current; }
    [[nodiscard]] bool busy() const { return m_thread.busy(); }

signals:
    /// Of a phase other voxels are cut than before.
    void made(int phase);
    /// There is not memory enough: what was cut before stays.
    void failed(const QString& sentence);
    void busyChanged(bool busy);

private:
    [[nodiscard]] int next() const;
    void makeNext();

    /// A phase's mask, and the volumes that were made with it, the newest first, by the voxels that they share.
    struct Cut {
        Volume::SharedMask mask;  ///< null where nothing is cut
        bool current = true;      ///< whether it is that of the strokes
        std::vector<std::pair<std::shared_ptr<const Volume>, std::shared_ptr<const Volume>>> volumes{};
    };
    void take(int phase, Volume::SharedMask mask);

    Phases m_scans;
    std::vector<Cut> m_cut;
    std::vector<ScalpelStroke> m_strokes;
    std::shared_ptr<ScalpelCuts> m_cuts;  ///< for the thread alone, null before the first stroke
    int m_wanted = 0;
    // Last, so that its thread has ended before anything above is destroyed.
    NewestWinsThread m_thread;
};

}  // namespace echolucent
