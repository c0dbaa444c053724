// The frames of a sweep: their OTFs, and their pictures.
#pragma once

#include <array>
#include <cstddef>
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

/// The view from which the motion of a document turns.
[[nodiscard]] Viewpoint startOf(Document document);

/// One turn of the document's motion, which repeats: its last `before` frames count as shown before the first.
[[nodiscard]] Frames turnFrames(const DocumentStudy& made, std::size_t before);

/// The phases, with quiet voxels of those that the frames show.
[[nodiscard]] StudyPhases withQuiet(StudyPhases phases, const std::vector<SweepFrame>& frames);

/// The OTF of the view from which the motion begins, for all frames.
[[nodiscard]] std::vector<SweptOtf> withOneOtf(const DocumentStudy& made, const StudyPhases& phases,
                                               const std::vector<SweepFrame>& frames);
/// The OTF of each frame's own view and phase, smoothed over the frames before it.
[[nodiscard]] std::vector<SweptOtf> withOwnOtfs(const DocumentStudy& made, const StudyPhases& phases,
                                                const Frames& frames, OtfSmoothing smoothing);

/// Casts the frames of a document's motion as the window shows them at rest, with adaptive OTFs.
class FramePictures {
public:
    FramePictures(const DocumentStudy& made, const StudyPhases& phases, const std::array<int, 2>& size);
    [[nodiscard]] Picture of(const SweepFrame& frame, const SampledCurve& curve);

private:
    Document m_document;
    std::size_t m_pane;
    PaneCaster m_caster;
    std::array<int, 2> m_size;
};

}  // namespace echolucent::cli
