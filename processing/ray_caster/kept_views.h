// The samples of the views that were just cast, for edits of the curve under a fixed camera.
#pragma once

#include <list>

#include "processing/picture/ray_cast_settings.h"
#include "processing/ray_caster/kernel_job.h"
#include "processing/ray_caster/sample_use.h"

namespace echolucent::ray_casting {

/// Samples are kept from a view's second picture on; a move of the camera forgets all.
class KeptViews {
public:
    /// Forgets all: what the samples are of has changed.
    void forget() { m_views.clear(); }
    /// Where this view's samples go, or are already; null where the view is new or would not fit into memoryLimit
    /// bytes.
    [[nodiscard]] KeptSamples* samplesFor(const RayCastSettings& settings, const RayGeometry& rays,
                                          std::size_t memoryLimit);
    /// A picture begins of whose samples none are kept or used.
    void useNone();
    /// The picture that samplesFor() was asked for is finished: from now on all of its samples are known.
    void finishPicture();
    /// How the newest finished picture used samples.
    [[nodiscard]] SampleUse sampleUse() const { return m_finished; }
    [[nodiscard]] std::size_t bytes() const;

private:
    /// Views, apart in size or step, that are told apart: preview and fine pictures come in turn.
    static constexpr std::size_t mostViews = 4;
    struct KeptView {
        RayCastSettings key;
        KeptSamples samples;
        bool complete = false;  ///< the samples of a whole picture are there
    };
    std::list<KeptView> m_views;  // newest first
    bool m_keeps = false;         // the picture being cast fills the samples of the newest view, or uses them
    SampleUse m_casting = SampleUse::taken, m_finished = SampleUse::taken;
};

}  // namespace echolucent::ray_casting
