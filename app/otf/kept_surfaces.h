// Keeps the surfaces with which panes are measured, so that all who measure find them once.
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <memory>
#include <mutex>
#include <vector>

#include "processing/pane_picture/pane_measures.h"
#include "processing/progress.h"
#include "processing/volume/volume.h"

namespace echolucent {

/// Finds the surfaces of a source in its voxels, and keeps the newest. An edit of a curve changes neither source nor
/// voxels, so nothing is found anew. Any thread may ask: worker threads share this object, and it guards itself. It
/// keeps no voxels alive.
class KeptSurfaces {
public:
    /// measuredSurfacesOf(source, *raw), kept from before if they are there. A thread waits while another one finds
    /// surfaces, so that both get the same ones. Null only if progress.cancel was raised, also while it waited; then
    /// nothing is kept.
    [[nodiscard]] std::shared_ptr<const MeasuredSurfaces> of(const SurfaceSource& source,
                                                             const std::shared_ptr<const Volume>& raw,
                                                             const Progress& progress = {});
    /// How many times surfaces were found so far, and not kept from before.
    [[nodiscard]] int timesFound() const { return m_timesFound; }

    /// The newest ones are kept: each pane may show a phase of its own.
    static constexpr std::size_t mostKept = mostPanes;

private:
    struct Kept {
        SurfaceSource source;
        std::weak_ptr<const Volume> raw;
        std::shared_ptr<const MeasuredSurfaces> surfaces;
    };

    std::mutex m_mutex;  ///< guards what follows; held for moments only
    std::condition_variable m_ended;
    bool m_finding = false;    ///< a thread finds surfaces
    std::vector<Kept> m_kept;  ///< the newest last
    std::atomic<int> m_timesFound = 0;
};

}  // namespace echolucent
