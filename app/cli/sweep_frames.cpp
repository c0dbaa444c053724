#include "app/cli/sweep_frames.h"

#include <tbb/task_arena.h>

#include <map>
#include <memory>
#include <utility>

#include "processing/pane_picture/pane_frames.h"
#include "processing/parallel.h"
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
    return documentAt(m_document, m_pane, frame.degrees, frame.phase);
}

void FrameCaster::compute(std::span<SweptOtf* const> ofPhase) {
    const auto voxels = m_caster.otfVoxels(documentOf(ofPhase.front()->frame), m_pane);
    parallelFor(LoopRange<std::size_t>(0, ofPhase.size(), 1), [&](const auto& range) {
        for (std::size_t i = range.begin(); i < range.end(); ++i) {
            SweptOtf& otf = *ofPhase[i];
            // A thread that waits for a frame's tube cores must not begin another frame: frames would pile up on its
            // stack.
            otf = sweptOtf(otf.frame, *tbb::this_task_arena::isolate(
                                          [&] { return adaptiveOtfOf(documentOf(otf.frame), m_pane, *voxels); }));
        }
    });
}

std::vector<SweptOtf> FrameCaster::otfs(const Frames& frames) {
    // By phase and angle, so that the voxels of a phase are cut once. One OTF for all frames stands at {0, 0}.
    std::map<std::pair<int, double>, SweptOtf> made;
    const auto keyOf = [this](const SweepFrame& frame) {
        return m_smoothing ? std::pair(frame.phase, frame.degrees) : std::pair(0, 0.0);
    };
    for (const SweepFrame& frame : frames.frames)
        made.emplace(keyOf(frame), SweptOtf{.frame = frame, .unsmoothed = {}, .shown = {}});
    for (auto next = made.begin(); next != made.end();) {
        std::vector<SweptOtf*> ofPhase;
        const int phase = next->first.first;
        for (; next != made.end() && next->first.first == phase; ++next) ofPhase.push_back(&next->second);
        compute(ofPhase);
    }
    OtfHistory history(m_smoothing.value_or(OtfSmoothing::none));
    std::vector<SweptOtf> swept;
    const auto count = static_cast<std::ptrdiff_t>(frames.frames.size());
    for (auto i = -static_cast<std::ptrdiff_t>(frames.before); i < count; ++i) {
        const SweepFrame& frame = frames.frames[static_cast<std::size_t>((i % count + count) % count)];
        SweptOtf otf = made.at(keyOf(frame));
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
