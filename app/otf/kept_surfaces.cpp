#include "app/otf/kept_surfaces.h"

#include <algorithm>
#include <chrono>
#include <mutex>
#include <utility>

namespace echolucent {

std::shared_ptr<const MeasuredSurfaces> KeptSurfaces::of(const SurfaceSource& source,
                                                         const std::shared_ptr<const Volume>& raw,
                                                         const Progress& progress) {
    // Whoever is cancelled leaves at once, whatever another thread still finds.
    constexpr std::chrono::milliseconds poll{5};
    std::unique_lock lock(m_mutex, std::defer_lock);
    do {
        if (progress.cancelled()) return nullptr;
    } while (!lock.try_lock_for(poll));
    const auto kept =
        std::ranges::find_if(m_kept, [&](const Kept& one) { return one.raw.lock() == raw && one.source == source; });
    if (kept != m_kept.end()) return kept->surfaces;
    auto found = measuredSurfacesOf(source, *raw, progress);
    if (!found) return nullptr;
    ++m_timesFound;
    auto surfaces = std::make_shared<const MeasuredSurfaces>(std::move(*found));
    if (m_kept.size() == mostKept) m_kept.erase(m_kept.begin());
    m_kept.push_back({source, raw, surfaces});
    return surfaces;
}

}  // namespace echolucent
