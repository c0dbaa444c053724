#include "app/otf/kept_surfaces.h"

#include <algorithm>
#include <utility>

namespace echolucent {

std::shared_ptr<const MeasuredSurfaces> KeptSurfaces::of(const SurfaceSource& source,
                                                         const std::shared_ptr<const Volume>& raw,
                                                         const Progress& progress) {
    const std::lock_guard lock(m_mutex);
    if (progress.cancelled()) return nullptr;
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
