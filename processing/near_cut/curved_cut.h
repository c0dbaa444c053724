// A smooth surface just inside the fluid, through what all tube cores saw.
#pragma once

#include <optional>
#include <span>

#include "processing/near_cut/fluid_stretches.h"
#include "processing/viewpoint/cut_surface.h"

namespace echolucent {

/// The smooth surface that lies just inside the fluid of as many tube cores as can be. It is a thin plate, fitted to
/// the places where tube cores enter fluid. It is fitted ten times, and places far from the surface lose weight. Over
/// tube cores that saw no fluid, the surface goes on smoothly. It stays between the shallowest and the deepest of those
/// places, so it lies nowhere before the data. If it is steeper than 60 degrees between neighbouring nodes, a fit is
/// repeated with a stiffer plate, up to four times; the last try counts. `stretches` are those of one level behind a
/// wall, sorted by tube core. `flatSample` is the depth of the flat cut, in samples. The result is empty if fewer than
/// 30 tube cores have a stretch.
[[nodiscard]] std::optional<CutSurface> fitCurvedCut(const TubeEcho& tubes, std::span<const FluidStretch> stretches,
                                                     double flatSample);

}  // namespace echolucent
