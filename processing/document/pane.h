// What one pane of the window shows of the scene.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "processing/adaptive/adaptive_otf_config.h"
#include "processing/designers/choice/designer_config.h"
#include "processing/document/curve_set.h"
#include "processing/motion/motion_mode.h"

namespace echolucent {

/// How a pane classifies voxels, and which phase and OTFs it shows.
struct Pane {
    CurveKind curve = CurveKind::adaptive;     ///< rendered if there is no designer
    std::optional<DesignerConfig> designer{};  ///< the designer's OTF is rendered in place of the curve
    /// Row-major numbers of the tube cores that are never placed for this pane's adaptive OTF, in addition to the
    /// method's (TubeGrid::withoutTubes).
    std::vector<int> withoutTubes{};
    /// How the adaptive method is run for this pane; none: as the document's. The initial function and the tube cores
    /// that are never placed are always the document's, and play no part here. The first pane has none.
    std::optional<AdaptiveOtfConfig> method{};
    std::optional<LinearCurve> linear{};  ///< the pane's own piecewise linear curve; none: that of the document
    std::optional<int> phase{};  ///< the pane's own phase, counted from 0; none: the scene's. The first pane has none.
    /// Which OTF the frames of a motion show in this pane; none: the one chosen in the document's motion. The first
    /// pane has none.
    std::optional<MotionOtf> motionOtf{};
    friend bool operator==(const Pane&, const Pane&) = default;
};

/// What is wrong with a pane, in words as problemOf(Scene) gives them.
[[nodiscard]] std::string problemOf(const Pane& pane);

}  // namespace echolucent
