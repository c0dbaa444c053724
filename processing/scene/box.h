// The render box, as a person sets it. Only what lies in it is shown, lit and read by tube cores.
#pragma once

#include <string>

#include "processing/scene/pose.h"
#include "processing/viewpoint/oriented_box.h"
#include "processing/viewpoint/viewpoint.h"
#include "processing/volume/volume.h"

namespace echolucent {

struct Box {
    bool on = false;            ///< if false, all of the volume is shown
    ViewDirection direction{};  ///< the way from top to bottom, and the turn about it, relative to the beam
    Vec3 centreMm{0, 0, 0};     ///< grid mm
    Vec3 sizeMm{0, 0, 0};  ///< from left to right, from far to near, from top to bottom; each above 0. All 0: nobody
                           ///< has set the box yet, and it is off
    friend bool operator==(const Box&, const Box&) = default;
};

/// The box in the grid: its axes are right (left to right), down (far to near) and forward (top to bottom).
[[nodiscard]] OrientedBox orientedBoxOf(const Box& box, BeamAxis beam);
/// The smallest box with the given box's direction around all data (Volume::dataBox()). It is switched on.
[[nodiscard]] Box wholeBox(const Box& box, BeamAxis beam, const DataBox& data);
/// What is wrong with a box that was read from a file: lower case, no full stop. Empty if nothing is wrong.
[[nodiscard]] std::string problemOf(const Box& box);

}  // namespace echolucent
