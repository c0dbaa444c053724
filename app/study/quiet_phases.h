// Makes the quiet voxels of a study's phases, once a phase in a thread of its own, and keeps them.
#pragma once

#include <QObject>
#include <QString>
#include <cstddef>
#include <memory>
#include <vector>

#include "processing/intensity/histogram.h"
#include "processing/speckle_reduction/speckle_reduction.h"
#include "processing/volume/volume.h"
#include "widgets/threads/newest_wins_thread.h"

namespace echolucent {

/// Makes the wanted phases first. Those that follow are made as long as they fit into keptBytesLimit. Call it in the
/// thread it lives in; it sends its signals there too.
class QuietPhases : public QObject {
    Q_OBJECT

public:
    using Phases = std::vector<std::shared_ptr<const Volume>>;

    explicit QuietPhases(Works& works, QObject* parent = nullptr);

    /// Another study is open: forgets what was made and makes nothing until want().
    void begin(Phases raw);
    /// Wants a phase (counted from 0) with a reduction, and another phase after it, which may be the same. Another
    /// reduction forgets what was made.
    void want(int phase, SpeckleReduction reduction, int another);
    void want(int phase, SpeckleReduction reduction) { want(phase, reduction, phase); }
    /// Ends what is being made; the next want() begins again.
    void cancel();

    /// The quiet voxels of a phase; null if they are not made or there is no such phase. The raw voxels if speckle is
    /// not reduced.
    [[nodiscard]] std::shared_ptr<const Volume> of(int phase) const;
    /// The histogram of the phase's quiet voxels; null if they are not made, as always if speckle is not reduced.
    [[nodiscard]] std::shared_ptr<const IntensityHistogram> histogramOf(int phase) const;
    [[nodiscard]] bool busy() const { return m_thread.busy(); }
    [[nodiscard]] int phaseCount() const { return static_cast<int>(m_raw.size()); }
    [[nodiscard]] int madeCount() const;
    /// Bytes that the quiet voxels take.
    [[nodiscard]] std::size_t bytes() const;
    [[nodiscard]] SpeckleReduction reduction() const { return m_reduction; }

    /// The most bytes of quiet voxels that are kept. The wanted phases are kept always.
    static constexpr std::size_t keptBytesLimit = std::size_t{2} << 30;

    /// Makes voxels quiet. Tests put in a function that ends on command.
    using Reduce = std::function<std::optional<Volume>(const Volume&, SpeckleReduction, const Progress&)>;
    void setReduce(Reduce reduce) { m_reduce = std::move(reduce); }

signals:
    void made(int phase);
    /// There is not enough memory. The phase stays as it is, and no other is made until begin() or another reduction.
    void failed(int phase, const QString& sentence);
    void busyChanged(bool busy);

private:
    [[nodiscard]] int keptAtMost() const;
    [[nodiscard]] int next() const;
    void makeNext();
    /// The quiet voxels of a phase and their histogram.
    struct Quiet {
        std::shared_ptr<const Volume> voxels;  ///< null if not made
        std::shared_ptr<const IntensityHistogram> histogram;
    };
    void take(int phase, Quiet quiet);

    Reduce m_reduce;
    Phases m_raw;
    std::vector<Quiet> m_quiet;
    std::vector<int> m_order;  ///< the phases kept, the one made first at the front
    SpeckleReduction m_reduction = SpeckleReduction::off;
    int m_wanted = 0;
    int m_another = 0;      ///< wanted after m_wanted
    bool m_failed = false;  // with this study and this reduction
    int m_making = -1;      ///< -1 if none is being made
    // Last, so that its thread has ended before anything above is destroyed.
    NewestWinsThread m_thread;
};

}  // namespace echolucent
