// The render box, as a person sets it. Only what lies in it is shown, lit and read by tube cores.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "processing/scene/pose.h"
#include "processing/viewpoint/oriented_box.h"
#include "processing/viewpoint/viewpoint.h"
#include "processing/volume/volume.h"

namespace echolucent {

/// A side of the box. The top of an unturned box is nearest to the probe. Left, right and near are those of plane A's
/// viewer (processing/scene/planes.h): near is the side towards the viewer.
enum class BoxSide { top, bottom, left, right, near, far };

/// All sides in the order of their buttons and keys.
inline constexpr std::array<BoxSide, 6> allBoxSides{BoxSide::top,   BoxSide::bottom, BoxSide::left,
                                                    BoxSide::right, BoxSide::near,   BoxSide::far};

/// "top", "bottom", "left", "right", "near", "far".
[[nodiscard]] std::string_view nameOf(BoxSide side);
[[nodiscard]] std::optional<BoxSide> boxSideFromName(std::string_view name);

struct Box {
    bool on = false;            ///< if false, all of the volume is shown
    ViewDirection direction{};  ///< the way from top to bottom, and the turn about it, relative to the beam
    Vec3 centreMm{0, 0, 0};     ///< grid mm
    Vec3 sizeMm{0, 0, 0};  ///< from left to right, from far to near, from top to bottom; each above 0. All 0: nobody
                           ///< has set the box yet, and it is off
    BoxSide side = BoxSide::top;  ///< through which tube cores look in, unless Scene::side is set otherwise
    friend bool operator==(const Box&, const Box&) = default;
};

/// The box in the grid: its axes are right (left to right), down (far to near) and forward (top to bottom).
[[nodiscard]] OrientedBox orientedBoxOf(const Box& box, BeamAxis beam);
/// The smallest box with the given box's direction around all data (Volume::dataBox()). It has the given box's side and
/// is switched on.
[[nodiscard]] Box wholeBox(const Box& box, BeamAxis beam, const DataBox& data);
/// The way from a side into the box, with the picture's down. From near, far, left and right the top is up, as in the
/// planes. From top and bottom near is down.
[[nodiscard]] ViewFrame frameFrom(BoxSide side, const ViewFrame& boxAxes);
/// frameFrom() of a box, as a direction relative to the beam.
[[nodiscard]] ViewDirection directionFrom(BoxSide side, const Box& box, BeamAxis beam);

/// What is wrong with a box that was read from a file: lower case, no full stop. Empty if nothing is wrong.
[[nodiscard]] std::string problemOf(const Box& box);

}  // namespace echolucent
