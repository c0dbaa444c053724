// The render box, as a person sets it: only what lies in it is shown, lit and read by tube cores.
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

/// A side of the box. Where the box is not turned, its top is nearest to the probe, and it is seen in plane A as its
/// viewer sees it (processing/scene/planes.h): left and right as there, near is the side towards the viewer.
enum class BoxSide { top, bottom, left, right, near, far };

/// All sides in the order of their buttons and keys.
inline constexpr std::array<BoxSide, 6> allBoxSides{BoxSide::top,   BoxSide::bottom, BoxSide::left,
                                                    BoxSide::right, BoxSide::near,   BoxSide::far};

/// "top", "bottom", "left", "right", "near", "far".
[[nodiscard]] std::string_view nameOf(BoxSide side);
[[nodiscard]] std::optional<BoxSide> boxSideFromName(std::string_view name);

struct Box {
    bool on = false;              ///< where false, all of the volume is shown
    ViewDirection direction{};    ///< the way from top to bottom, and the turn about it, relative to the beam
    Vec3 centreMm{0, 0, 0};       ///< grid mm
    Vec3 sizeMm{0, 0, 0};         ///< from left to right, from far to near, from top to bottom; each above 0, or all 0
                                  ///< where nobody has set the box yet, which then is off
    BoxSide side = BoxSide::top;  ///< the side through which the adaptive OTF looks in
    friend bool operator==(const Box&, const Box&) = default;
};

/// The box in the grid: its axes are right (left to right), down (far to near) and forward (top to bottom).
[[nodiscard]] OrientedBox orientedBoxOf(const Box& box, BeamAxis beam);
/// The least box of the given box's direction around all data (Volume::dataBox()), with its side and switched on.
[[nodiscard]] Box wholeBox(const Box& box, BeamAxis beam, const DataBox& data);
/// The way from a side into the box, with the picture's down: from near, far, left and right the top is up, as in the
/// planes; from top and bottom near is down.
[[nodiscard]] ViewFrame frameFrom(BoxSide side, const ViewFrame& boxAxes);
/// The same as a direction relative to the beam.
[[nodiscard]] ViewDirection directionFrom(BoxSide side, const Box& box, BeamAxis beam);

/// What is wrong with a box that was read from a file, lower case, no full stop; an empty text where nothing is.
[[nodiscard]] std::string problemOf(const Box& box);

}  // namespace echolucent
