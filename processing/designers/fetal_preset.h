// The opacity curve of 3D Slicer's preset for fetal ultrasound.
#pragma once

#include <array>

#include "processing/opacity_curve.h"

namespace echolucent {

/// The nodes of the curve. 3D Slicer gives them over levels from 0 to 255: opacity 0 up to level 60, 0.6 at 120, 0.8 at
/// white.
inline constexpr std::array<CurveNode, 3> fetalPresetNodes{{{60.0 / 255.0, 0.0}, {120.0 / 255.0, 0.6}, {1.0, 0.8}}};

}  // namespace echolucent
