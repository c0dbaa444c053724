#include "processing/viewpoint/box_section.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace echolucent {

namespace {

Vec3 axisOf(const OrientedBox& box, int axis) {
    return axis == 0 ? box.axes.right : axis == 1 ? box.axes.down : box.axes.forward;
}

/// Any direction across a normal.
Vec3 across(const Vec3& normal) {
    const Vec3 other = std::abs(normal[0]) < 0.6 ? Vec3(1, 0, 0) : Vec3(0, 1, 0);
    return normalized(normal.cross(other));
}

/// The part of a polygon on the inner side of a face (Sutherland and Hodgman's clipping). The new edge lies on that
/// face.
BoxSection clipped(const BoxSection& polygon, const OrientedBox& box, const BoxFace& face) {
    const Vec3 normal = outwardNormal(box, face);
    const double outside = normal.dot(middleOf(box, face));
    const auto beyond = [&](const Vec3& corner) { return normal.dot(corner) - outside; };
    BoxSection left;
    for (std::size_t i = 0; i < polygon.corners.size(); ++i) {
        const Vec3 &from = polygon.corners[i], &to = polygon.corners[(i + 1) % polygon.corners.size()];
        const double a = beyond(from), b = beyond(to);
        const auto crossing = [&] { return from + (to - from) * (a / (a - b)); };
        if (a <= 0.0) {
            left.corners.push_back(from);
            left.faces.push_back(polygon.faces[i]);
            if (b > 0.0) {
                left.corners.push_back(crossing());
                left.faces.push_back(face);
            }
        } else if (b <= 0.0) {
            left.corners.push_back(crossing());
            left.faces.push_back(polygon.faces[i]);
        }
    }
    return left;
}

}  // namespace

Vec3 outwardNormal(const OrientedBox& box, const BoxFace& face) { return axisOf(box, face.axis) * face.sign; }

Vec3 middleOf(const OrientedBox& box, const BoxFace& face) {
    return box.centreMm + outwardNormal(box, face) * (0.5 * box.sizeMm[face.axis]);
}

BoxSection sectionOf(const OrientedBox& box, const Vec3& pointMm, const Vec3& normal) {
    // Begin with a square in the plane, larger than any section of the box.
    const double reach = length(box.sizeMm);
    const Vec3 centre = box.centreMm - normal * normal.dot(box.centreMm - pointMm);
    const Vec3 u = across(normal) * reach, v = normal.cross(u);
    BoxSection section{{centre - u - v, centre + u - v, centre + u + v, centre - u + v}, std::vector<BoxFace>(4)};
    for (int axis = 0; axis < 3; ++axis)
        for (const int sign : {-1, 1}) section = clipped(section, box, {axis, sign});
    if (section.corners.size() < 3) return {};
    return section;
}

/// Two boxes lie apart if their shadows lie apart on a face's normal, or on a line across an edge of each.
bool meets(const OrientedBox& box, const DataBox& data) {
    const OrientedBox other = orientedBoxOf(data);
    const std::array<Vec3, 3> ours{box.axes.right, box.axes.down, box.axes.forward};
    const std::array<Vec3, 3> theirs{other.axes.right, other.axes.down, other.axes.forward};
    std::vector<Vec3> directions(ours.begin(), ours.end());
    directions.insert(directions.end(), theirs.begin(), theirs.end());
    for (const Vec3& our : ours)
        for (const Vec3& their : theirs) directions.push_back(our.cross(their));
    const Vec3 between = other.centreMm - box.centreMm;
    return std::ranges::all_of(directions, [&](const Vec3& direction) {
        return std::abs(direction.dot(between)) <= 0.5 * (box.extentAlong(direction) + other.extentAlong(direction));
    });
}

OrientedBox withFaceMoved(const OrientedBox& box, const BoxFace& face, double mm, double leastMm) {
    const double moved = std::max(mm, std::min(0.0, leastMm - box.sizeMm[face.axis]));
    OrientedBox next = box;
    next.sizeMm[face.axis] += moved;
    next.centreMm += outwardNormal(box, face) * (0.5 * moved);
    return next;
}

Vec3 rotatedAbout(const Vec3& axis, double degrees, const Vec3& vector) {
    const double radians = degrees * std::numbers::pi / 180.0;
    return vector * std::cos(radians) + axis.cross(vector) * std::sin(radians) +
           axis * (axis.dot(vector) * (1.0 - std::cos(radians)));
}

OrientedBox turnedAbout(const OrientedBox& box, const Vec3& axis, double degrees) {
    OrientedBox next = box;
    next.axes.right = rotatedAbout(axis, degrees, box.axes.right);
    next.axes.down = rotatedAbout(axis, degrees, box.axes.down);
    next.axes.forward = rotatedAbout(axis, degrees, box.axes.forward);
    return next;
}

}  // namespace echolucent
