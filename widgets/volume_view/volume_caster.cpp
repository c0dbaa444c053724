#include "widgets/volume_view/volume_caster.h"

#include <memory>
#include <utility>

#include "processing/ray_caster.h"

namespace echolucent {

namespace {

class VolumeCaster {
public:
    CastResult cast(const PictureRequest& request, const Progress& progress) {
        if (m_caster && request.volume && request.volume->isSameScanAs(*m_caster->volume())) {
            m_caster->setCut(request.volume);
        } else {
            m_caster.reset();
            if (!request.volume) return {};
            m_caster.emplace(request.volume);
        }
        std::optional<Picture> picture = m_caster->cast(request.classification, request.settings, progress);
        return {std::move(picture), m_caster->sampleUse(), m_caster->lightMilliseconds()};
    }

private:
    std::optional<RayCaster> m_caster;
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
