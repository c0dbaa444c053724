// Turns and steps planes until one of them holds given places.
#pragma once

#include <vector>

#include "processing/scene/planes.h"

namespace echolucent {

/// Planes of which one holds all of two or three places (grid mm, within the data box). The present planes are turned
/// as little as possible about the reference point, and stepped. If the places lie on one straight line, the turn about
/// that line stays. Pictures show the same part of the data as before, but a magnified one has the places in its
/// middle. Planes that hold the places already stay as they are.
[[nodiscard]] Planes planesHolding(const Planes& planes, const std::vector<Vec3>& placesMm, BeamAxis beam,
                                   const DataBox& data);

}  // namespace echolucent
