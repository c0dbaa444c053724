// The pictures of a motion, frame by frame: what a movie of a pane shows.
#pragma once

#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "processing/motion/motion_choice.h"
#include "processing/motion/otf_smoothing.h"
#include "processing/pane_picture/pane_caster.h"

namespace echolucent {

/// framesOfTurn() of a document's motion in a study of `phases` phases (>= 1). Whatever does not move stays as the pane
/// shows it.
[[nodiscard]] std::vector<MotionPosition> turnOf(const Document& document, std::size_t pane, int phases);

/// The document with a pane at an angle of the motion, degrees, and in a phase.
[[nodiscard]] Document documentAt(Document document, std::size_t pane, double degrees, int phase);

/// One turn of a motion (turnOf()), which may be shown over and over. A frame is the document's pane turned by the
/// frame's angle, of the frame's phase, in converged quality. If the pane is rendered with the adaptive OTF,
/// MotionChoice::otf chooses which (Pane::motionOtf must be empty, as it is in the first pane):
///   oneOtf      the OTF of otfPhaseOf() along the method's direction, for every frame;
///   eachView    the OTF of the frame's own view and phase: the frame is panePicture() of documentOf(), to the bit;
///   the others  as eachView, smoothed over the frames before. The turn counts as shown before, so that the first frame
///               follows the last one smoothly.
/// If the pane has a designer, the designer computes one OTF, of otfPhaseOf(), for oneOtf. For all other choices it
/// computes an OTF for each frame, and none is smoothed. Only one thread at a time may use a PaneFrames.
class PaneFrames {
public:
    PaneFrames(Document document, std::size_t pane, StudyPhases phases);

    /// At least one.
    [[nodiscard]] int count() const { return static_cast<int>(m_turn.size()); }
    /// Angle and phase of a frame; frames count from 0 (std::out_of_range if there is no such frame).
    [[nodiscard]] const MotionPosition& position(int frame) const { return m_turn.at(static_cast<std::size_t>(frame)); }
    /// The document that shows a frame at rest. If each frame has its own OTF, smoothed or not, the document's OTF is
    /// computed along the frame's direction.
    [[nodiscard]] Document documentOf(int frame) const;
    /// The first frame whose picture this one has, to the bit: on the way back a motion passes the places of its way
    /// there. If OTFs are smoothed, each frame has its own.
    [[nodiscard]] int firstLike(int frame) const;
    /// The picture of a frame. Frames may be asked for in any order; one after another is quickest. The result is empty
    /// only if progress.cancel was raised.
    [[nodiscard]] std::optional<PanePicture> picture(int frame, int width, int height, const Progress& progress = {});

private:
    [[nodiscard]] std::optional<PaneOtf> unsmoothed(int frame, const Progress& progress);
    [[nodiscard]] std::optional<PaneOtf> otf(int frame, const Progress& progress);

    Document m_document;
    std::size_t m_pane;
    PaneCaster m_caster;
    std::vector<MotionPosition> m_turn;
    std::map<std::pair<int, int>, PaneOtf> m_otfs;  ///< unsmoothed, by angle and phase; for oneOtf only {0, 0}
};

}  // namespace echolucent
