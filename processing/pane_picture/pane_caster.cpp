#include "processing/pane_picture/pane_caster.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "processing/adaptive/adaptive_otf.h"
#include "processing/designers/choice/designer.h"
#include "processing/picture/converged.h"
#include "processing/picture/view_limits.h"
#include "processing/speckle_reduction/speckle_reduction.h"

namespace echolucent {

namespace {

const VolumeGeometry& gridOf(const StudyPhases& phases) {
    if (phases.scans.empty()) throw std::invalid_argument("PaneCaster: a study has at least one phase");
    return phases.scans.front()->geometry();
}

}  // namespace

RayCastSettings castSettingsOf(const Document& document, const VolumeGeometry& geometry, const DataBox& box, int width,
                               int height) {
    const Look& look = document.scene.look;
    const Pose pose = shownPose(document);
    RayCastSettings settings = rayCastSettings(shownLook(document.scene));
    settings.width = width;
    settings.height = height;
    const double aspect = static_cast<double>(width) / height;
    settings.camera = cameraFor(cameraPoseOf(pose, document.beam.axis, box, look.projection, aspect));
    return limitedTo(viewpointOf(document), geometry, std::move(settings));
}

bool needsComputedOtf(const Document& document, std::size_t pane) {
    const Pane& shown = document.panes.at(pane);
    const bool computed = shown.designer || shown.curve == CurveKind::adaptive;
    return computed && document.scene.look.mode == RenderMode::direct;
}

Classification classificationOf(const Document& document, std::size_t pane, const PaneOtf& otf) {
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

PaneCaster::PaneCaster(StudyPhases phases) : m_phases(std::move(phases)), m_cuts(gridOf(m_phases)) {}

PaneCaster::AskedVoxels PaneCaster::askedVoxels(const Document& document, int phase) {
    return {phase, document.scene.strokes, document.scene.look.reduction};
}

const PaneCaster::Voxels* PaneCaster::voxels(const AskedVoxels& asked, const Progress& progress) {
    if (m_voxels && m_voxels->asked == asked) return &*m_voxels;
    const auto place = static_cast<std::size_t>(asked.phase);
    const Volume& scan = *m_phases.scans.at(place);
    const std::vector<ScalpelStroke>& strokes = asked.strokes;
    const auto raw = m_cuts.cut(scan, strokes, progress);
    if (!raw) return nullptr;
    Voxels made{.asked = asked};
    made.raw = std::make_shared<const Volume>(*raw);
    if (asked.reduction == SpeckleReduction::off) {
        made.shown = made.raw;
    } else if (asked.reduction == m_phases.reduction && place < m_phases.quiet.size() && m_phases.quiet[place]) {
        made.shown = std::make_shared<const Volume>(m_phases.quiet[place]->withCut(raw->cut()));
    } else {
        const auto quiet = quietVolume(*raw, asked.reduction, progress);
        if (!quiet) return nullptr;
        made.shown = std::make_shared<const Volume>(quiet->withDataBox(scan.dataBox()));
    }
    m_voxels = std::move(made);
    return &*m_voxels;
}

std::optional<PaneCaster::OtfVoxels> PaneCaster::otfVoxels(const Document& document, std::size_t pane,
                                                           const Progress& progress) {
    return phaseVoxels(document, otfPhaseOf(document, pane, phaseCount()), progress);
}

std::optional<PaneCaster::OtfVoxels> PaneCaster::phaseVoxels(const Document& document, int phase,
                                                             const Progress& progress) {
    const Voxels* of = voxels(askedVoxels(document, phase), {{}, progress.cancel});
    return of ? std::optional(OtfVoxels{of->raw, of->shown}) : std::nullopt;
}

std::optional<PaneOtf> PaneCaster::otf(const Document& document, std::size_t pane, const Progress& progress) {
    if (!needsComputedOtf(document, pane)) return PaneOtf{};
    const DesignerConfig* designer = designerConfigOf(document, pane);
    AskedOtf asked{.voxels = askedVoxels(document, otfPhaseOf(document, pane, phaseCount()))};
    if (designer != nullptr) asked.designer = *designer;
    if (designer == nullptr || readsTubeCores(*designer)) {
        asked.viewpoint = otfViewpointOf(document, pane);
        asked.method = configOf(document, pane);
    }
    if (m_askedOtf == asked) return m_otf;
    auto computed = computedOtf(document, pane, progress);
    if (!computed) return std::nullopt;
    m_askedOtf = std::move(asked);
    m_otf = *computed;
    return computed;
}

std::optional<PaneOtf> PaneCaster::computedOtf(const Document& document, std::size_t pane, const Progress& progress) {
    if (const DesignerConfig* config = designerConfigOf(document, pane)) {
        const Progress silent{{}, progress.cancel};
        const Voxels* of = voxels(askedVoxels(document, otfPhaseOf(document, pane, phaseCount())), silent);
        if (!of) return std::nullopt;
        auto made = design(*config, designerInputOf(document, pane, *of->raw, *of->shown, of->asked.reduction), silent);
        if (!made) return std::nullopt;
        return PaneOtf{.designed = std::move(made->classification), .message = std::move(made->message)};
    }
    auto read = readTubeCores(document, pane, progress);
    if (!read) return std::nullopt;
    return PaneOtf{.curve = std::move(read->otf.curve), .message = std::move(read->otf.message)};
}

std::optional<AdaptiveOtf> adaptiveOtfOf(const Document& document, std::size_t pane,
                                         const PaneCaster::OtfVoxels& voxels, const Progress& progress) {
    const SpeckleReduction reduction = document.scene.look.reduction;
    const QuietVoxels shown =
        reduction == SpeckleReduction::off ? QuietVoxels{} : QuietVoxels{voxels.shown.get(), reduction};
    return adaptOpacity(*voxels.raw, otfViewpointOf(document, pane), configOf(document, pane), progress, shown);
}

std::optional<PaneCaster::TubeCoreReading> PaneCaster::readTubeCores(const Document& document, std::size_t pane,
                                                                     const Progress& progress) {
    const auto of = otfVoxels(document, pane, progress);
    if (!of) return std::nullopt;
    auto otf = adaptiveOtfOf(document, pane, *of, {{}, progress.cancel});
    if (!otf) return std::nullopt;
    return TubeCoreReading{std::move(*otf), of->shown};
}

RayCaster& PaneCaster::raysThrough(const std::shared_ptr<const Volume>& volume, bool withoutKeptSamples) {
    if (!m_rays || withoutKeptSamples || !m_rays->volume()->isSameScanAs(*volume))
        m_rays.emplace(volume);
    else if (m_rays->volume() != volume)
        m_rays->setCut(volume);
    return *m_rays;
}

std::optional<PanePicture> PaneCaster::picture(const Document& document, std::size_t pane, int width, int height,
                                               const Progress& progress, PictureQuality quality) {
    const auto computed = otf(document, pane, progress);
    return computed ? pictureWith(*computed, document, pane, width, height, progress, quality) : std::nullopt;
}

std::optional<PanePicture> PaneCaster::pictureWith(const PaneOtf& otf, const Document& document, std::size_t pane,
                                                   int width, int height, const Progress& progress,
                                                   PictureQuality quality) {
    auto made = pictureOf(classificationOf(document, pane, otf), document, pane, width, height, progress, quality);
    if (made) made->message = otf.message;
    return made;
}

std::optional<PanePicture> PaneCaster::pictureOf(const Classification& classification, const Document& document,
                                                 std::size_t pane, int width, int height, const Progress& progress,
                                                 PictureQuality quality) {
    const Voxels* of = voxels(askedVoxels(document, phaseOf(document, pane)), Progress{{}, progress.cancel});
    if (!of) return std::nullopt;
    const RayCastSettings asked = castSettingsOf(document, of->shown->geometry(), of->shown->dataBox(), width, height);
    const bool isConverged = quality == PictureQuality::converged;
    const RayCastSettings settings = isConverged ? converged(asked) : asked;
    // A picture that RayCaster makes from kept samples is exact to half a level only.
    RayCaster& rays = raysThrough(of->shown, isConverged && m_cast.camera == settings.camera);
    m_cast = settings;
    auto picture = rays.cast(classification, settings, progress);
    if (!picture) return std::nullopt;
    return PanePicture{std::move(*picture), settings, classification, of->shown, {}};
}

}  // namespace echolucent
