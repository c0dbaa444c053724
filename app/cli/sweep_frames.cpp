#include "app/cli/sweep_frames.h"

#include <map>
#include <memory>
#include <utility>

#include "processing/pane_picture/pane_frames.h"
#include "processing/speckle_reduction/speckle_reduction.h"

namespace echolucent::cli {

Frames turnFrames(const DocumentStudy& made, std::size_t before) {
    const Document& document = made.document;
    const Viewpoint start = motionStartOf(document);
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

FrameCaster::FrameCaster(const DocumentStudy& made, const StudyPhases& phases, std::optional<OtfSmoothing> smoothing)
    : m_document(withCurve(made.document, made.pane, CurveKind::adaptive)),
      m_pane(made.pane),
      m_smoothing(smoothing),
      m_caster(phases) {
    m_document.panes.at(m_pane).motionOtf = smoothing ? MotionOtf::eachView : MotionOtf::oneOtf;
}

Document FrameCaster::documentOf(const SweepFrame& frame) const {
    Document document = m_document;
    document.scene.motionAngle = frame.degrees;
    auto& ownPhase = document.panes.at(m_pane).phase;
    (ownPhase ? *ownPhase : document.scene.phase) = frame.phase;
    return document;
}

std::vector<SweptOtf> FrameCaster::otfs(const Frames& frames) {
    std::map<std::pair<double, int>, SweptOtf> known;  // by angle and phase; one OTF stands at {0, 0}
    OtfHistory history(m_smoothing.value_or(OtfSmoothing::none));
    std::vector<SweptOtf> swept;
    const auto count = static_cast<std::ptrdiff_t>(frames.frames.size());
    for (auto i = -static_cast<std::ptrdiff_t>(frames.before); i < count; ++i) {
        const SweepFrame& frame = frames.frames[static_cast<std::size_t>((i % count + count) % count)];
        const auto key = m_smoothing ? std::pair(frame.degrees, frame.phase) : std::pair(0.0, 0);
        if (!known.contains(key))
            known.emplace(key, sweptOtf(frame, m_caster.readTubeCores(documentOf(frame), m_pane)->otf));
        SweptOtf otf = known.at(key);
        otf.frame = frame;
        otf.shown = history.add(static_cast<double>(i), otf.unsmoothed);
        if (i >= 0) swept.push_back(std::move(otf));
    }
    return swept;
}

Picture FrameCaster::picture(const SweepFrame& frame, const SampledCurve& curve, const std::array<int, 2>& size) {
    return std::move(m_caster.pictureWith({.curve = curve}, documentOf(frame), m_pane, size[0], size[1])->picture);
}

}  // namespace echolucent::cli
