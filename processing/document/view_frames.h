// The pictures of a document's motion in turn: what a movie of a view shows.
#pragma once

#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "processing/document/view_caster.h"
#include "processing/motion/motion_choice.h"
#include "processing/motion/otf_smoothing.h"

namespace echolucent {

/// framesOfTurn() of a document's motion in a study of `phases` phases (>= 1): what does not move stays as the view
/// shows it.
[[nodiscard]] std::vector<MotionPosition> turnOf(const Document& document, std::size_t pane, int phases);

/// One turn of a motion (turnOf()), which can be shown over and over. Its frames are those of the document's
/// view: turned by the frame's angle, of the frame's phase, in the converged quality of viewPicture(), and with the OTF
/// that MotionChoice::otf names where the adaptive one plays a part:
///   oneOtf      that of otfPhaseOf() along the method's direction, for every frame;
///   eachView    that of the frame's own view and phase: the frame is viewPicture() of documentOf(), to the bit;
///   the others  the same, smoothed over the frames before it. The turn counts as having been shown before, so that the
///               first frame follows smoothly upon the last one.
/// A view with a design has what its designer makes of otfPhaseOf() in the first case, of each frame in all others.
/// Only one thread at a time may use it.
class ViewFrames {
public:
    ViewFrames(Document document, std::size_t pane, StudyPhases phases);

    /// At least one.
    [[nodiscard]] int count() const { return static_cast<int>(m_turn.size()); }
    /// Angle and phase of a frame, which is counted from 0 (std::out_of_range where there is none).
    [[nodiscard]] const MotionPosition& position(int frame) const { return m_turn.at(static_cast<std::size_t>(frame)); }
    /// The document that shows a frame at rest. Where each frame has its own OTF, it is computed along the frame's
    /// direction, also while these are smoothed.
    [[nodiscard]] Document documentOf(int frame) const;
    /// The picture of a frame. Frames may be asked for in any order; in turn they are quickest. The result is empty
    /// only where progress.cancel was raised.
    [[nodiscard]] std::optional<ViewPicture> picture(int frame, int width, int height, const Progress& progress = {});

private:
    [[nodiscard]] std::optional<ViewOtf> unsmoothed(int frame, const Progress& progress);
    [[nodiscard]] std::optional<ViewOtf> otf(int frame, const Progress& progress);

    Document m_document;
    std::size_t m_pane;
    ViewCaster m_caster;
    std::vector<MotionPosition> m_turn;
    std::map<std::pair<int, int>, ViewOtf> m_otfs;  ///< unsmoothed, by angle and phase; one OTF stands at {0, 0}
};

}  // namespace echolucent
