// The samples of the newest views, for edits of the curve under a fixed camera.
#pragma once

#include <list>

#include "processing/picture/ray_cast_settings.h"
#include "processing/ray_caster/kernel_job.h"
#include "processing/ray_caster/sample_use.h"

namespace echolucent::ray_casting {

/// Keeps samples from a view's second picture on. A move of the camera forgets all of them.
class KeptViews {
public:
    /// Forgets all samples, because the voxels have changed.
    void forget() { m_views.clear(); }
    /// Where the samples of this view are kept. Null at the view's first picture, in a mode other than direct, and if
    /// the samples would not fit into memoryLimit bytes. At the second picture the place is empty, and the caster fills
    /// it.
    [[nodiscard]] KeptSamples* samplesFor(const RayCastSettings& settings, const RayGeometry& rays,
                                          std::size_t memoryLimit);
    /// A picture begins that neither keeps nor uses samples.
    void useNone();
    /// The picture of the newest samplesFor() is finished. From now on all of its samples are known.
    void finishPicture();
    /// How the newest finished picture used samples.
    [[nodiscard]] SampleUse sampleUse() const { return m_finished; }
    [[nodiscard]] std::size_t bytes() const;

private:
    /// How many views of one camera it keeps apart, by size or step: preview and fine pictures take turns.
    static constexpr std::size_t mostViews = 4;
    struct KeptView {
        RayCastSettings key;
        KeptSamples samples;
        bool complete = false;  ///< the samples of a whole picture are there
    };
    std::list<KeptView> m_views;  // newest first
    bool m_keeps = false;         // whether the picture being cast fills or uses the newest view's samples
    SampleUse m_casting = SampleUse::taken, m_finished = SampleUse::taken;
};

}  // namespace echolucent::ray_casting
