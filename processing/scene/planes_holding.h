// Turns and steps planes until one of them holds given places.
#pragma once

#include <vector>

#include "processing/scene/planes.h"

namespace echolucent {

/// Planes of which one holds all of two or three places (grid mm, within the data box). The present planes are turned
/// as little as possible about the reference point, and stepped. If the places lie on one straight line, the turn about
/// that line stays. Pictures show the same part of the data as before. If the picture of the plane that holds the
/// places is magnified, it moves so that the places are in its middle. Planes of which one holds the places already
/// neither turn nor step.
[[nodiscard]] Planes planesHolding(const Planes& planes, const std::vector<Vec3>& placesMm, BeamAxis beam,
                                   const DataBox& data);

}  // namespace echolucent
