// What one pane of the window shows of the scene.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "processing/designers/choice/designer_config.h"
#include "processing/document/curve_set.h"
#include "processing/motion/motion_mode.h"

namespace echolucent {

/// What the voxels of a pane are classified with.
struct Pane {
    CurveKind curve = CurveKind::adaptive;     ///< rendered where there is no designer
    std::optional<DesignerConfig> designer{};  ///< whose OTF is rendered in the curve's place
    /// Row-major numbers of tube cores that are never placed for this pane's adaptive OTF, beside those of the method
    /// (TubeGrid::withoutTubes).
    std::vector<int> withoutTubes{};
    std::optional<int> phase{};  ///< of its own, counted from 0; none: that of the scene. The first pane has none.
    /// Which OTF the frames of a motion show in this pane; none: that of the document's motion.
    std::optional<MotionOtf> motionOtf{};
    friend bool operator==(const Pane&, const Pane&) = default;
};

/// What is wrong with a pane, as problemOf(Scene).
[[nodiscard]] std::string problemOf(const Pane& pane);

}  // namespace echolucent
