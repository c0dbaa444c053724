#include "widgets/volume_view/volume_caster.h"

#include <algorithm>
#include <memory>
#include <vector>

namespace echolucent {

namespace {

class VolumeCaster {
public:
    CastResult cast(const PictureRequest& request, const Progress& progress) {
        if (!m_caster || m_caster->volume() != request.volume) {
            m_caster.reset();
            m_views.clear();
            if (!request.volume) return {};
            m_caster.emplace(request.volume);
        }
        Viewpoint& view = viewOf(request);
        const std::size_t keptBefore = m_caster->keptSampleBytes();
        CastResult result{m_caster->cast(request.curve, request.settings, progress), SampleUse::taken};
        if (view.finished > 1) result.samples = view.kept ? SampleUse::kept : SampleUse::notKept;
        // The ray caster keeps the samples of a view's second picture.
        if (view.finished == 1) view.kept = view.kept || m_caster->keptSampleBytes() > keptBefore;
        if (result.picture) ++view.finished;
        return result;
    }

private:
    struct Viewpoint {
        PictureRequest request;
        int finished = 0;
        bool kept = false;
    };

    /// Those of one camera are remembered together, as the ray caster does; another camera forgets them.
    Viewpoint& viewOf(const PictureRequest& request) {
        const auto sameCamera = [&](const Viewpoint& view) {
            return view.request.settings.camera == request.settings.camera;
        };
        if (!std::all_of(m_views.begin(), m_views.end(), sameCamera)) m_views.clear();
        const auto found = std::find_if(m_views.begin(), m_views.end(),
                                        [&](const Viewpoint& view) { return sameSamples(view.request, request); });
        return found != m_views.end() ? *found : m_views.emplace_back(Viewpoint{request});
    }

    std::optional<RayCaster> m_caster;
    std::vector<Viewpoint> m_views;
};

}  // namespace

Cast castThroughOneRayCaster() {
    // std::function copies what it holds; the caster itself must not be copied.
    return [caster = std::make_shared<VolumeCaster>()](const PictureRequest& request, const Progress& progress) {
        return caster->cast(request, progress);
    };
}

bool sameSamples(const PictureRequest& a, const PictureRequest& b) {
    RayCastSettings recoloured = a.settings;
    recoloured.colourMap = b.settings.colourMap;
    return a.volume == b.volume && recoloured == b.settings;
}

}  // namespace echolucent
