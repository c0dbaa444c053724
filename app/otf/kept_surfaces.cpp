#include "app/otf/kept_surfaces.h"

#include <algorithm>
#include <chrono>
#include <mutex>
#include <utility>

namespace echolucent {

std::shared_ptr<const MeasuredSurfaces> KeptSurfaces::of(const SurfaceSource& source,
                                                         const std::shared_ptr<const Volume>& raw,
                                                         const Progress& progress) {
    constexpr std::chrono::milliseconds poll{5};
    std::unique_lock lock(m_mutex);
    // Whoever is cancelled leaves at once, whatever another thread still finds.
    while (!progress.cancelled() && m_finding) m_ended.wait_for(lock, poll);
    if (progress.cancelled()) return nullptr;
    const auto kept =
        std::ranges::find_if(m_kept, [&](const Kept& one) { return one.raw.lock() == raw && one.source == source; });
    if (kept != m_kept.end()) return kept->surfaces;

    m_finding = true;
    lock.unlock();
    std::shared_ptr<const MeasuredSurfaces> surfaces;
    const auto end = [&] {
        lock.lock();
        m_finding = false;
        m_ended.notify_all();
    };
    try {
        if (auto found = measuredSurfacesOf(source, *raw, progress))
            surfaces = std::make_shared<const MeasuredSurfaces>(std::move(*found));
    } catch (...) {
        end();
        throw;
    }
    end();
    if (!surfaces) return nullptr;
    ++m_timesFound;
    if (m_kept.size() == mostKept) m_kept.erase(m_kept.begin());
    m_kept.push_back({source, raw, surfaces});
    return surfaces;
}

}  // namespace echolucent
