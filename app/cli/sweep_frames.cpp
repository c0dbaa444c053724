#include "app/cli/sweep_frames.h"

#include <memory>
#include <span>
#include <utility>

#include "processing/pane_picture/pane_frames.h"
#include "processing/scalpel/scalpel_cuts.h"
#include "processing/speckle_reduction/speckle_reduction.h"

namespace echolucent::cli {

namespace {

/// The frames with those that were shown before the first of them.
std::vector<SweepFrame> withBefore(const Frames& turn) {
    std::vector<SweepFrame> all;
    const auto count = static_cast<std::ptrdiff_t>(turn.frames.size());
    for (auto i = -static_cast<std::ptrdiff_t>(turn.before); i < count; ++i) {
        all.push_back(turn.frames[static_cast<std::size_t>((i % count + count) % count)]);
        all.back().time = static_cast<double>(i);
    }
    return all;
}

/// The phases, cut by strokes of the scalpel.
StudyPhases withStrokes(StudyPhases phases, std::span<const ScalpelStroke> strokes) {
    if (strokes.empty()) return phases;
    ScalpelCuts cuts(phases.scans.front()->geometry());
    for (std::size_t i = 0; i < phases.scans.size(); ++i) {
        const Volume left = *cuts.cut(*phases.scans[i], strokes);
        if (i < phases.quiet.size() && phases.quiet[i])
            phases.quiet[i] = std::make_shared<const Volume>(phases.quiet[i]->withCut(left.cut()));
        phases.scans[i] = std::make_shared<const Volume>(left);
    }
    return phases;
}

std::vector<QuietVoxels> shownVoxels(const StudyPhases& phases) {
    std::vector<QuietVoxels> shown;
    for (const auto& quiet : phases.quiet) shown.push_back({quiet.get(), phases.reduction});
    return shown;
}

}  // namespace

Viewpoint startOf(Document document) {
    document.scene.motionAngle = 0.0;
    return viewpointOf(document);
}

Frames turnFrames(const DocumentStudy& made, std::size_t before) {
    const Document& document = made.document;
    const Viewpoint start = startOf(document);
    Frames turn{.before = before};
    for (const MotionPosition& at : turnOf(document, made.pane, static_cast<int>(made.study.phases.size())))
        turn.frames.push_back({static_cast<double>(turn.frames.size()), static_cast<double>(at.angle), at.phase,
                               turned(start, document.motion.axis, at.angle)});
    return turn;
}

StudyPhases withQuiet(StudyPhases phases, const std::vector<SweepFrame>& frames) {
    if (phases.reduction == SpeckleReduction::off) return phases;
    phases.quiet.resize(phases.scans.size());
    for (const SweepFrame& frame : frames) {
        const auto place = static_cast<std::size_t>(frame.phase);
        const Volume& scan = *phases.scans[place];
        if (!phases.quiet[place])
            phases.quiet[place] =
                std::make_shared<const Volume>(quietVolume(scan, phases.reduction)->withDataBox(scan.dataBox()));
    }
    return phases;
}

std::vector<SweptOtf> withOneOtf(const DocumentStudy& made, const StudyPhases& phases,
                                 const std::vector<SweepFrame>& frames) {
    const AdaptiveOtf otf = PaneCaster(phases).readTubeCores(made.document, made.pane)->otf;
    double sumOfD = 0.0;
    for (const TubeCore& tube : otf.tubes) sumOfD += tube.d;
    std::vector<SweptOtf> swept;
    swept.reserve(frames.size());
    for (const SweepFrame& frame : frames) swept.push_back({frame, otf.curve, otf.curve, sumOfD, otf.tubesWithWeight});
    return swept;
}

std::vector<SweptOtf> withOwnOtfs(const DocumentStudy& made, const StudyPhases& phases, const Frames& frames,
                                  OtfSmoothing smoothing) {
    const StudyPhases left = withStrokes(phases, made.document.scene.strokes);
    auto swept = *sweepOtfs(left.scans, withBefore(frames), configOf(made.document, made.pane), smoothing, {},
                            shownVoxels(left));
    swept.erase(swept.begin(), swept.begin() + static_cast<std::ptrdiff_t>(frames.before));
    return swept;
}

FramePictures::FramePictures(const DocumentStudy& made, const StudyPhases& phases, const std::array<int, 2>& size)
    : m_document(withCurve(made.document, made.pane, CurveKind::adaptive)),
      m_pane(made.pane),
      m_caster(phases),
      m_size(size) {}

Picture FramePictures::of(const SweepFrame& frame, const SampledCurve& curve) {
    m_document.scene.motionAngle = frame.degrees;
    auto& ownPhase = m_document.panes.at(m_pane).phase;
    (ownPhase ? *ownPhase : m_document.scene.phase) = frame.phase;
    return std::move(m_caster.pictureWith({.curve = curve}, m_document, m_pane, m_size[0], m_size[1])->picture);
}

}  // namespace echolucent::cli
