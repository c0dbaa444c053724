// The samples of the views that were just cast, for edits of the curve under a fixed camera.
#pragma once

#include <list>

#include "processing/ray_caster.h"
#include "processing/ray_caster/kernel_job.h"

namespace echolucent::ray_casting {

/// A view is kept from its second picture on; a move of the camera forgets all.
class KeptViews {
public:
    /// Where this view's samples go, or are already; null where the view is new or would not fit into memoryLimit
    /// bytes.
    [[nodiscard]] KeptSamples* samplesFor(const RayCastSettings& settings, const RayGeometry& rays,
                                          std::size_t memoryLimit);
    void clear() { m_views.clear(); }
    [[nodiscard]] std::size_t bytes() const;

private:
    /// Views, apart in size or step, that are told apart: preview and fine pictures come in turn.
    static constexpr std::size_t mostViews = 4;
    struct KeptView {
        RayCastSettings key;
        KeptSamples samples;
    };
    std::list<KeptView> m_views;  // newest first
};

}  // namespace echolucent::ray_casting
