#include "processing/pane_picture/pane_frames.h"

#include <algorithm>
#include <cmath>

namespace echolucent {

std::vector<MotionPosition> turnOf(const Document& document, std::size_t pane, int phases) {
    const MotionPosition at{.angle = static_cast<int>(std::lround(document.scene.motionAngle)),
                            .phase = phaseOf(document, pane)};
    return framesOfTurn(document.motion, phases, at);
}

Document documentAt(Document document, std::size_t pane, double degrees, int phase) {
    document.scene.motionAngle = degrees;
    auto& ownPhase = document.panes.at(pane).phase;
    (ownPhase ? *ownPhase : document.scene.phase) = phase;
    return document;
}

PaneFrames::PaneFrames(Document document, std::size_t pane, StudyPhases phases)
    : m_document(std::move(document)),
      m_pane(pane),
      m_caster(std::move(phases)),
      m_turn(turnOf(m_document, pane, m_caster.phaseCount())) {}

Document PaneFrames::documentOf(int frame) const {
    const MotionPosition& at = position(frame);
    Document shown = documentAt(m_document, m_pane, at.angle, at.phase);
    if (smoothingOf(shown.motion.otf)) shown.scene.side = shownPose(shown).direction;
    return shown;
}

int PaneFrames::firstLike(int frame) const {
    const bool smoothed = needsComputedOtf(m_document, m_pane) && designerConfigOf(m_document, m_pane) == nullptr &&
                          smoothingOf(m_document.motion.otf).value_or(OtfSmoothing::none) != OtfSmoothing::none;
    if (smoothed) return frame;
    const MotionPosition& at = position(frame);
    const auto first = std::ranges::find_if(
        m_turn, [&at](const MotionPosition& each) { return each.angle == at.angle && each.phase == at.phase; });
    return static_cast<int>(first - m_turn.begin());
}

std::optional<PaneOtf> PaneFrames::unsmoothed(int frame, const Progress& progress) {
    const bool one = !smoothingOf(m_document.motion.otf);
    const MotionPosition& at = position(frame);
    const std::pair key = one ? std::pair(0, 0) : std::pair(at.angle, at.phase);
    if (const auto known = m_otfs.find(key); known != m_otfs.end()) return known->second;
    const auto computed = m_caster.otf(documentOf(frame), m_pane, progress);
    if (computed) m_otfs.emplace(key, *computed);
    return computed;
}

std::optional<PaneOtf> PaneFrames::otf(int frame, const Progress& progress) {
    // A designer's OTF may be two-dimensional, so it is not smoothed.
    if (designerConfigOf(m_document, m_pane) != nullptr) return unsmoothed(frame, progress);
    const OtfSmoothing smoothing = smoothingOf(m_document.motion.otf).value_or(OtfSmoothing::none);
    OtfHistory history(smoothing);
    PaneOtf shown;
    for (int before = static_cast<int>(framesUsed(smoothing)) - 1; before >= 0; --before) {
        // The turn is a ring: before its first frame comes its last one.
        const int place = ((frame - before) % count() + count()) % count();
        const auto own = unsmoothed(place, progress);
        if (!own) return std::nullopt;
        shown = {.curve = history.add(-before, own->curve), .message = own->message};
    }
    return shown;
}

std::optional<PanePicture> PaneFrames::picture(int frame, int width, int height, const Progress& progress) {
    PaneOtf shown;
    if (needsComputedOtf(m_document, m_pane)) {
        auto computed = otf(frame, progress);
        if (!computed) return std::nullopt;
        shown = std::move(*computed);
    }
    return m_caster.pictureWith(shown, documentOf(frame), m_pane, width, height, progress);
}

}  // namespace echolucent
