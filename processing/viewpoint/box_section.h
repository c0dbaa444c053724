// How a plane cuts a box, and how a box changes if a face moves or the box turns.
#pragma once

#include <vector>

#include "processing/viewpoint/oriented_box.h"

namespace echolucent {

/// A face of a box, at the larger (+1) or the smaller (-1) end of one of its axes.
struct BoxFace {
    int axis = 0;  ///< 0 right, 1 down, 2 forward
    int sign = 1;
    friend bool operator==(const BoxFace&, const BoxFace&) = default;
};

/// The unit normal of a face, in grid mm. It points out of the box.
[[nodiscard]] Vec3 outwardNormal(const OrientedBox& box, const BoxFace& face);
/// The middle of a face, grid mm.
[[nodiscard]] Vec3 middleOf(const OrientedBox& box, const BoxFace& face);

/// The convex polygon in which a plane cuts a box. Edge i goes from corner i to the next corner (from the last to the
/// first) and lies on faces[i]. Both lists are empty if the plane misses the box.
struct BoxSection {
    std::vector<Vec3> corners;  ///< grid mm
    std::vector<BoxFace> faces;
};
/// The section of the plane through `pointMm` with the normal `normal`, which has length 1.
[[nodiscard]] BoxSection sectionOf(const OrientedBox& box, const Vec3& pointMm, const Vec3& normal);

/// Whether a box and the data box have a place in common.
[[nodiscard]] bool meets(const OrientedBox& box, const DataBox& data);

/// The box with a face moved outwards by `mm` (inwards if negative). The opposite face stays in place. The face stops
/// if the box is `leastMm` (above 0) thick; a box that is thinner already gets no thinner.
[[nodiscard]] OrientedBox withFaceMoved(const OrientedBox& box, const BoxFace& face, double mm, double leastMm);
/// A vector rotated about an axis of length 1, right-handed (Rodrigues' formula).
[[nodiscard]] Vec3 rotatedAbout(const Vec3& axis, double degrees, const Vec3& vector);
/// The box turned about its centre and an axis of length 1, right-handed.
[[nodiscard]] OrientedBox turnedAbout(const OrientedBox& box, const Vec3& axis, double degrees);

}  // namespace echolucent
