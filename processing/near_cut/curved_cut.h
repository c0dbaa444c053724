// A smooth surface just inside the fluid, through what all tube cores saw.
#pragma once

#include <optional>
#include <span>

#include "processing/near_cut/fluid_stretches.h"
#include "processing/viewpoint/cut_surface.h"

namespace echolucent {

/// The smooth surface that lies just inside the fluid of as many tube cores as can be: a thin plate over the places
/// where they enter it, fitted again and again while those that stay far from it lose weight. It goes on smoothly where
/// no tube core saw fluid, lies nowhere before the data, and is nowhere steeper than 60 degrees. `stretches` are those
/// behind a wall, `flatSample` is the plane that opens most of them. The result is empty where too few tube cores tell.
[[nodiscard]] std::optional<CutSurface> fitCurvedCut(const TubeEcho& tubes, std::span<const FluidStretch> stretches,
                                                     double flatSample);

}  // namespace echolucent
