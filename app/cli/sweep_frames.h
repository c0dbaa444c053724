// The frames of a sweep: their OTFs, and their pictures.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "app/cli/options/document_study.h"
#include "processing/motion/otf_smoothing.h"
#include "processing/motion/otf_sweep.h"
#include "processing/opacity_curve.h"
#include "processing/pane_picture/pane_caster.h"
#include "processing/picture/picture.h"

namespace echolucent::cli {

/// The frames, and how many of the last ones count as having been shown before the first.
struct Frames {
    std::vector<SweepFrame> frames{};
    std::size_t before = 0;
};

/// One turn of the document's motion, which repeats: its last `before` frames count as shown before the first.
[[nodiscard]] Frames turnFrames(const DocumentStudy& made, std::size_t before);

/// The phases, with quiet voxels of those that the frames show.
[[nodiscard]] StudyPhases withQuiet(StudyPhases phases, const std::vector<SweepFrame>& frames);

/// Makes the adaptive OTFs and the pictures of a motion's frames, as the window shows them at rest.
class FrameCaster {
public:
    /// With a smoothing each frame has the OTF of its own view and phase, smoothed over the frames before it. Without
    /// one, all frames have the OTF of the document's side and of the phase otfPhaseOf().
    FrameCaster(const DocumentStudy& made, const StudyPhases& phases, std::optional<OtfSmoothing> smoothing);
    [[nodiscard]] std::vector<SweptOtf> otfs(const Frames& frames);
    [[nodiscard]] Picture picture(const SweepFrame& frame, const SampledCurve& curve, const std::array<int, 2>& size);

private:
    [[nodiscard]] Document documentOf(const SweepFrame& frame) const;

    Document m_document;
    std::size_t m_pane;
    std::optional<OtfSmoothing> m_smoothing;
    PaneCaster m_caster;
};

}  // namespace echolucent::cli
