#include "processing/document/view_frames.h"

#include <algorithm>
#include <cmath>

namespace echolucent {

std::vector<MotionPosition> turnOf(const Document& document, int view, int phases) {
    const MotionPosition at{.angle = static_cast<int>(std::lround(document.motionAngle)),
                            .phase = phaseOf(document, view)};
    return framesOfTurn(document.motion, phases, at);
}

ViewFrames::ViewFrames(Document document, int view, StudyPhases phases)
    : m_document(std::move(document)),
      m_view(view),
      m_caster(std::move(phases)),
      m_turn(turnOf(m_document, view, m_caster.phaseCount())) {}

Document ViewFrames::documentOf(int frame) const {
    const MotionPosition& at = position(frame);
    Document shown = m_document;
    shown.motionAngle = at.angle;
    phaseOf(shown, m_view) = at.phase;
    if (smoothingOf(shown.motion.otf)) shown.method.direction = shownPose(shown, m_view).direction;
    return shown;
}

std::optional<ViewOtf> ViewFrames::unsmoothed(int frame, const Progress& progress) {
    const bool one = !smoothingOf(m_document.motion.otf);
    const MotionPosition& at = position(frame);
    const std::pair key = one ? std::pair(0, 0) : std::pair(at.angle, at.phase);
    if (const auto known = m_otfs.find(key); known != m_otfs.end()) return known->second;
    const auto computed = m_caster.otf(documentOf(frame), m_view, progress);
    if (computed) m_otfs.emplace(key, *computed);
    return computed;
}

std::optional<ViewOtf> ViewFrames::otf(int frame, const Progress& progress) {
    // What designers make may be two-dimensional, and is not smoothed.
    if (designOf(m_document, m_view) != nullptr) return unsmoothed(frame, progress);
    const OtfSmoothing smoothing = smoothingOf(m_document.motion.otf).value_or(OtfSmoothing::none);
    OtfHistory history(smoothing);
    ViewOtf shown;
    for (int before = static_cast<int>(framesUsed(smoothing)) - 1; before >= 0; --before) {
        // The turn is a ring: before its first frame comes its last one.
        const int place = ((frame - before) % count() + count()) % count();
        const auto own = unsmoothed(place, progress);
        if (!own) return std::nullopt;
        shown = {.curve = history.add(-before, own->curve), .message = own->message};
    }
    return shown;
}

std::optional<ViewPicture> ViewFrames::picture(int frame, int width, int height, const Progress& progress) {
    ViewOtf shown;
    if (needsComputedOtf(m_document, m_view)) {
        auto computed = otf(frame, progress);
        if (!computed) return std::nullopt;
        shown = std::move(*computed);
    }
    return m_caster.picture(documentOf(frame), m_view, width, height, shown, progress);
}

}  // namespace echolucent
