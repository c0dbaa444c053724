#include "widgets/volume_view/volume_caster.h"

#include <memory>

namespace echolucent {

namespace {

class VolumeCaster {
public:
    CastResult cast(const PictureRequest& request, const Progress& progress) {
        if (!m_caster || m_caster->volume() != request.volume) {
            m_caster.reset();
            m_before.reset();
            if (!request.volume) return {};
            m_caster.emplace(request.volume);
        }
        m_inARow = m_before && sameSamples(*m_before, request) ? m_inARow + 1 : 1;
        const bool kept = m_inARow > 1 && m_caster->keptSampleBytes() > 0;
        m_before = request;
        CastResult result{m_caster->cast(request.curve, request.settings, progress), SampleUse::taken};
        if (kept) {
            result.samples = SampleUse::kept;
        } else if (m_inARow > 2) {
            result.samples = SampleUse::notKept;
        }
        // A cancelled picture leaves no samples behind that could be counted on.
        if (!result.picture) m_inARow = 0;
        return result;
    }

private:
    std::optional<RayCaster> m_caster;
    std::optional<PictureRequest> m_before;
    int m_inARow = 0;  // pictures with the same samples, the newest included
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
