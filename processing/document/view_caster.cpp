#include "processing/document/view_caster.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "processing/adaptive/adaptive_otf.h"
#include "processing/designers/designer.h"
#include "processing/picture/converged.h"
#include "processing/picture/view_limits.h"
#include "processing/speckle_reduction/speckle_reduction.h"

namespace echolucent {

namespace {

const VolumeGeometry& gridOf(const StudyPhases& phases) {
    if (phases.scans.empty()) throw std::invalid_argument("ViewCaster: a study has at least one phase");
    return phases.scans.front()->geometry();
}

}  // namespace

RayCastSettings castSettingsOf(const Document& document, const VolumeGeometry& geometry, const DataBox& box, int width,
                               int height) {
    const Look& look = document.scene.look;
    const Pose pose = shownPose(document);
    const Front& front = document.scene.front;
    RayCastSettings settings = rayCastSettings(look);
    settings.width = width;
    settings.height = height;
    settings.camera = cameraFor(cameraPoseOf(pose, document.beam.axis, front.depthMm, box, look.projection,
                                             static_cast<double>(width) / height));
    Viewpoint limits = viewpointOf(document.beam.axis, pose.direction, front.depthMm);
    limits.cutSurface = front.surface;
    limits.box = viewpointOf(document).box;
    return limitedTo(limits, geometry, std::move(settings));
}

bool needsComputedOtf(const Document& document, std::size_t pane) {
    const Pane& shown = document.panes.at(pane);
    const bool computed = shown.designer || shown.curve == CurveKind::adaptive;
    return computed && document.scene.look.mode == RenderMode::direct;
}

Classification classificationOf(const Document& document, std::size_t pane, const ViewOtf& otf) {
    if (designerConfigOf(document, pane) == nullptr) return curveOf(document, pane, otf.curve);
    return adjustedClassification(otf.designed.value_or(Classification()), document.curves.adjustment);
}

DesignerInput designerInputOf(const Document& document, std::size_t pane, const Volume& raw, const Volume& shown,
                              SpeckleReduction reduction) {
    return {raw, shown, reduction, otfViewpointOf(document, pane), configOf(document, pane)};
}

int otfPhaseOf(const Document& document, std::size_t pane, int phases) {
    const MotionOtf otf = document.panes.at(pane).motionOtf.value_or(document.motion.otf);
    if (phases < 2 || otf != MotionOtf::oneOtf) return phaseOf(document, pane);
    return std::min(document.motion.otfPhase, phases - 1);
}

ViewCaster::ViewCaster(StudyPhases phases) : m_phases(std::move(phases)), m_cuts(gridOf(m_phases)) {}

const ViewCaster::Voxels* ViewCaster::voxels(const Document& document, int phase, const Progress& progress) {
    const SpeckleReduction reduction = document.scene.look.reduction;
    const std::vector<ScalpelStroke>& strokes = document.scene.strokes;
    if (m_voxels && m_voxels->phase == phase && m_voxels->reduction == reduction && m_voxels->strokes == strokes)
        return &*m_voxels;
    const auto place = static_cast<std::size_t>(phase);
    const Volume& scan = *m_phases.scans.at(place);
    const auto raw = m_cuts.cut(scan, strokes, progress);
    if (!raw) return nullptr;
    Voxels made{.phase = phase, .strokes = strokes, .reduction = reduction};
    made.raw = std::make_shared<const Volume>(*raw);
    if (reduction == SpeckleReduction::off) {
        made.shown = made.raw;
    } else if (reduction == m_phases.reduction && place < m_phases.quiet.size() && m_phases.quiet[place]) {
        made.shown = std::make_shared<const Volume>(m_phases.quiet[place]->withCut(raw->cut()));
    } else {
        const auto quiet = quietVolume(*raw, reduction, progress);
        if (!quiet) return nullptr;
        made.shown = std::make_shared<const Volume>(quiet->withDataBox(scan.dataBox()));
    }
    m_voxels = std::move(made);
    return &*m_voxels;
}

std::optional<ViewOtf> ViewCaster::otf(const Document& document, std::size_t pane, const Progress& progress) {
    const Progress silent{{}, progress.cancel};
    const Voxels* of = voxels(document, otfPhaseOf(document, pane, phaseCount()), silent);
    if (!of) return std::nullopt;
    if (const DesignerConfig* config = designerConfigOf(document, pane)) {
        auto made = design(*config, designerInputOf(document, pane, *of->raw, *of->shown, of->reduction), silent);
        if (!made) return std::nullopt;
        return ViewOtf{.designed = std::move(made->classification), .message = std::move(made->message)};
    }
    auto read = readTubeCores(document, pane, progress);
    if (!read) return std::nullopt;
    return ViewOtf{.curve = std::move(read->otf.curve), .message = std::move(read->otf.message)};
}

std::optional<ViewCaster::TubeCoreReading> ViewCaster::readTubeCores(const Document& document, std::size_t pane,
                                                                     const Progress& progress) {
    const Progress silent{{}, progress.cancel};
    const Voxels* of = voxels(document, otfPhaseOf(document, pane, phaseCount()), silent);
    if (!of) return std::nullopt;
    const QuietVoxels shown =
        of->reduction == SpeckleReduction::off ? QuietVoxels{} : QuietVoxels{of->shown.get(), of->reduction};
    auto otf = adaptOpacity(*of->raw, otfViewpointOf(document, pane), configOf(document, pane), silent, shown);
    if (!otf) return std::nullopt;
    return TubeCoreReading{std::move(*otf), of->shown};
}

std::optional<ViewPicture> ViewCaster::picture(const Document& document, std::size_t pane, int width, int height,
                                               const ViewOtf& otf, const Progress& progress, PictureQuality quality) {
    const Voxels* of = voxels(document, phaseOf(document, pane), Progress{{}, progress.cancel});
    if (!of) return std::nullopt;
    const RayCastSettings asked = castSettingsOf(document, of->shown->geometry(), of->shown->dataBox(), width, height);
    const RayCastSettings settings = quality == PictureQuality::converged ? converged(asked) : asked;
    const Classification classification = classificationOf(document, pane, otf);
    // From the samples of a view that is cast again pictures follow to half a level only.
    if (!m_rays || m_rays->volume() != of->shown || m_cast == settings) m_rays.emplace(of->shown);
    m_cast = settings;
    auto picture = m_rays->cast(classification, settings, progress);
    if (!picture) return std::nullopt;
    return ViewPicture{std::move(*picture), settings, classification, of->shown, otf.message};
}

}  // namespace echolucent
