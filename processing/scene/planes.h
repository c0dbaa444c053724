// The three planes A, B and C, as a person sets them.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

#include "processing/scene/pose.h"
#include "processing/viewpoint/view_frame.h"
#include "processing/viewpoint/viewpoint.h"
#include "processing/volume/volume.h"

namespace echolucent {

/// Three planes at right angles that meet in the reference point. If they are not turned, A and B hold the beam, which
/// runs down in their pictures. C lies across the beam and is seen from the probe.
enum class PlaneName { a, b, c };

/// All planes in the order of their panes.
inline constexpr std::array<PlaneName, 3> allPlaneNames{PlaneName::a, PlaneName::b, PlaneName::c};

[[nodiscard]] constexpr std::size_t indexOf(PlaneName plane) { return static_cast<std::size_t>(plane); }

/// "A", "B", "C".
[[nodiscard]] std::string_view nameOf(PlaneName plane);

/// Which part of a plane its picture shows.
struct PlaneCrop {
    double panRightMm = 0.0, panDownMm = 0.0;  ///< in the plane, from the data box's centre to the picture's centre
    double magnification = 1.0;  ///< above 0; at 1 the data box fits into all three unturned planes, at one scale
    friend bool operator==(const PlaneCrop&, const PlaneCrop&) = default;
};

struct Planes {
    ViewDirection direction{};         ///< the way plane C is looked at, relative to the beam
    Vec3 offsetMm{0, 0, 0};            ///< from the data box's centre to the reference point, grid mm
    std::array<PlaneCrop, 3> crops{};  ///< of A, B and C
    double window = 1.0;               ///< normalised intensities from black to white, [1/256, 4]
    double level = 0.5;                ///< normalised intensity that is shown half bright, [-1, 2]
    bool quiet = false;                ///< true: shows quiet voxels if the look reduces speckle; false: raw voxels
    bool linesIn3d = false;            ///< whether the 3D view shows where the planes lie
    bool turnsView = false;            ///< whether what turns the planes turns the 3D view along
    friend bool operator==(const Planes&, const Planes&) = default;
};

inline constexpr double largestPlaneWindow = 4.0;
inline constexpr double leastPlaneWindow = 1.0 / 256.0;
inline constexpr double leastPlaneLevel = -1.0, largestPlaneLevel = 2.0;

/// How a plane's picture lies in the grid: its right, its down, and forward, the way it is looked at. With r, d, f the
/// right, down and forward of the planes' direction: A is (r, f), seen along -d; B is (d, f), seen along r; C is (r,
/// d), seen along f. So C under A shows the same columns. What is at C's lower edge is near A's viewer.
[[nodiscard]] ViewFrame frameOf(PlaneName plane, const Planes& planes, BeamAxis beam);

/// Where the planes meet, grid mm. `data` is Volume::dataBox().
[[nodiscard]] Vec3 referencePointOf(const Planes& planes, const DataBox& data);
/// The planes with another reference point. If it lies beyond the data box, it stops at the box's border, on the
/// straight way from the present point.
[[nodiscard]] Planes withReferencePoint(Planes planes, const Vec3& gridMm, const DataBox& data);
/// The planes after a step (mm) along the way that one of them is looked at. They stay within the data box.
[[nodiscard]] Planes stepped(const Planes& planes, PlaneName plane, double mm, BeamAxis beam, const DataBox& data);
/// All three planes turned about the reference point, so that the picture of one of them turns clockwise. That plane
/// shows the same voxels as before. The reference point keeps its place in all three pictures.
[[nodiscard]] Planes turned(const Planes& planes, PlaneName plane, double degrees, BeamAxis beam);

/// The pose turned along with planes that were turned from `before` to `after`: by their turn, about the reference
/// point of `after`, which keeps its place in the picture. If the planes were not turned, the pose keeps its bits.
[[nodiscard]] Pose turnedAlong(const Pose& pose, const Planes& before, const Planes& after, BeamAxis beam);

/// What a picture of a plane shows. The place x mm right of its centre and y mm below it is centreMm + frame.right * x
/// + frame.down * y.
struct PlaneView {
    Vec3 centreMm{0, 0, 0};  ///< grid mm, in the plane
    ViewFrame frame{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    double heightMm = 1.0;  ///< of the picture, above 0
    friend bool operator==(const PlaneView&, const PlaneView&) = default;
};
/// The view of a plane in a picture of width / height `aspect` (> 0).
[[nodiscard]] PlaneView planeViewOf(const Planes& planes, PlaneName plane, BeamAxis beam, const DataBox& data,
                                    double aspect);

}  // namespace echolucent
