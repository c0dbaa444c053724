#include "app/cli/sweep_frames.h"

#include <map>
#include <memory>
#include <utility>

#include "processing/pane_picture/pane_frames.h"
#include "processing/speckle_reduction/speckle_reduction.h"

namespace echolucent::cli {

namespace {

/// The frames with those that count as shown before the first of them.
std::vector<SweepFrame> withBefore(const Frames& turn) {
    std::vector<SweepFrame> all;
    const auto count = static_cast<std::ptrdiff_t>(turn.frames.size());
    for (auto i = -static_cast<std::ptrdiff_t>(turn.before); i < count; ++i) {
        all.push_back(turn.frames[static_cast<std::size_t>((i % count + count) % count)]);
        all.back().time = static_cast<double>(i);
    }
    return all;
}

}  // namespace

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
    return documentAt(m_document, m_pane, frame.degrees, frame.phase);
}

std::vector<SweptOtf> FrameCaster::otfs(const Frames& frames) {
    // Without a smoothing, the OTF of one frame serves all.
    const std::vector<SweepFrame> asked = m_smoothing ? withBefore(frames) : std::vector{frames.frames.front()};
    std::map<int, PaneCaster::OtfVoxels> voxels;
    for (const SweepFrame& frame : asked)
        if (!voxels.contains(frame.phase)) voxels[frame.phase] = *m_caster.otfVoxels(documentOf(frame), m_pane);
    const FrameOtf otfOf = [&](const SweepFrame& frame, const Progress& progress) {
        return adaptiveOtfOf(documentOf(frame), m_pane, voxels.at(frame.phase), progress);
    };
    auto swept = *sweepOtfs(asked, otfOf, m_smoothing.value_or(OtfSmoothing::none));
    if (m_smoothing) {
        swept.erase(swept.begin(), swept.begin() + static_cast<std::ptrdiff_t>(frames.before));
        return swept;
    }
    std::vector<SweptOtf> same(frames.frames.size(), swept.front());
    for (std::size_t i = 0; i < same.size(); ++i) same[i].frame = frames.frames[i];
    return same;
}

Picture FrameCaster::picture(const SweepFrame& frame, const SampledCurve& curve, const std::array<int, 2>& size) {
    return std::move(m_caster.pictureWith({.curve = curve}, documentOf(frame), m_pane, size[0], size[1])->picture);
}

}  // namespace echolucent::cli
