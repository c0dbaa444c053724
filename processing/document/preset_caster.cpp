#include "processing/document/preset_caster.h"

#include <opencv2/imgproc.hpp>
#include <utility>

#include "processing/adaptive/adaptive_otf.h"
#include "processing/document/view_caster.h"

namespace echolucent {

namespace {

/// The picture at half the size in both directions.
Picture halved(Picture large) {
    Picture small = emptyPicture(large.width / 2, large.height / 2);
    const cv::Mat from(large.height, large.width, CV_32FC4, large.rgba.data());
    cv::Mat to(small.height, small.width, CV_32FC4, small.rgba.data());
    cv::resize(from, to, to.size(), 0, 0, cv::INTER_AREA);
    return small;
}

}  // namespace

std::optional<Picture> PresetCaster::cast(const Document& document, std::size_t pane, const Voxels& voxels, int width,
                                          int height, const Progress& progress) {
    const RayCastSettings settings =
        castSettingsOf(document, voxels.shown->geometry(), voxels.shown->dataBox(), 2 * width, 2 * height);
    static const SampledCurve none;
    const bool adaptive = document.panes.at(pane).curve == CurveKind::adaptive && settings.mode == RenderMode::direct;
    const SampledCurve* curve = adaptive ? adaptiveCurve(document, pane, voxels, progress) : &none;
    if (curve == nullptr) return std::nullopt;
    if (m_rays && m_rays->volume() != voxels.shown && m_rays->volume()->isSameScanAs(*voxels.shown))
        m_rays->setCut(voxels.shown);
    if (!m_rays || m_rays->volume() != voxels.shown) m_rays.emplace(voxels.shown);
    auto picture = m_rays->cast(curveOf(document, pane, *curve), settings, progress);
    if (!picture) return std::nullopt;
    return halved(std::move(*picture));
}

const SampledCurve* PresetCaster::adaptiveCurve(const Document& document, std::size_t pane, const Voxels& voxels,
                                                const Progress& progress) {
    AskedOtf asked{otfViewpointOf(document, pane), configOf(document, pane), voxels};
    if (m_asked == asked) return &m_adaptive;
    const QuietVoxels shown =
        voxels.shown == voxels.raw ? QuietVoxels{} : QuietVoxels{voxels.shown.get(), voxels.reduction};
    auto otf = adaptOpacity(*voxels.raw, asked.viewpoint, asked.config, Progress{{}, progress.cancel}, shown);
    if (!otf) return nullptr;
    m_asked = std::move(asked);
    m_adaptive = std::move(otf->curve);
    return &m_adaptive;
}

}  // namespace echolucent
