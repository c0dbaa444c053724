// How the adaptive method is run.
#pragma once

#include "processing/opacity_curve.h"
#include "processing/tube_core/rules/cell_rule.h"
#include "processing/tube_core/rules/curve_rule.h"
#include "processing/tube_core/rules/detection_rule.h"
#include "processing/tube_core/rules/surface_rule.h"
#include "processing/tube_core/rules/weight_rule.h"
#include "processing/tube_core/slabs/tube_grid.h"

namespace echolucent {

/// The default of a, the initial function's opacity at full intensity before the clamp. Chosen by looking.
inline constexpr double defaultOpacityScale = 1.0;

/// One rule for each stage. methodParameters() holds the range and source of every parameter.
struct AdaptiveOtfConfig {
    TubeGrid grid{};                        ///< where the tube cores lie
    CellRule cells{};                       ///< how the cells of the tube cores are read
    DetectionRule detection = RatioRule{};  ///< what tells tissue from fluid
    SurfaceRule surface{};                  ///< how I_L, I_H and slope are read around a surface
    WeightRule weights{};                   ///< how the tube cores are weighed
    CurveRule curve = RampRule{};           ///< what curve the tube cores make from the initial function
    OpacityCurve initial = PowerCurve{2, defaultOpacityScale};  ///< the initial function; its scale is a
    friend bool operator==(const AdaptiveOtfConfig&, const AdaptiveOtfConfig&) = default;
};

}  // namespace echolucent
