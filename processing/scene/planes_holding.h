// Planes turned and stepped so that one of them holds given places.
#pragma once

#include <vector>

#include "processing/scene/planes.h"

namespace echolucent {

/// Planes of which one holds all of two or three places (grid mm, within the data box): those present, turned as little
/// as possible about the reference point, and stepped. What lies on one straight line leaves the turn about that line
/// as it is. Pictures show the same part of the data as before; a magnified one has the places in its middle. Planes
/// that hold the places already stay as they are.
[[nodiscard]] Planes planesHolding(const Planes& planes, const std::vector<Vec3>& placesMm, BeamAxis beam,
                                   const DataBox& data);

}  // namespace echolucent
