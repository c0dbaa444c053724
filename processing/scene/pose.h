// From where a view looks at the volume, in values that mean the same for every study and every shape of a picture.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "processing/picture/camera_pose.h"
#include "processing/viewpoint/viewpoint.h"

namespace echolucent {

/// Who said which way sound travelled.
enum class BeamSource {
    assumed,      ///< nobody did; the default is taken
    sectorShape,  ///< found on opening: the scanned sector widens along it
    echo,         ///< found on opening: the echo falls along it, or shadows lie along it behind bright places
    person,       ///< chosen in the program
    file,         ///< the file says where the probe was
};
/// "assumed", "sector shape", "echo", "person", "file".
[[nodiscard]] std::string_view nameOf(BeamSource source);
[[nodiscard]] std::optional<BeamSource> beamSourceFromName(std::string_view name);

/// A direction of looking, relative to the beam axis: the angles of Viewpoint, degrees. All 0: along that axis.
struct ViewDirection {
    double azimuth = 0.0;
    double elevation = 0.0;  ///< [-90, 90]
    double roll = 0.0;
    friend bool operator==(const ViewDirection&, const ViewDirection&) = default;
};

/// The way sound travelled. It is the default view direction, seen from the probe.
struct Beam {
    BeamAxis axis = BeamAxis::plusZ;
    BeamSource source = BeamSource::assumed;
    ViewDirection lean{};  ///< of the beam itself, if a file says that it leans against its axis
    friend bool operator==(const Beam&, const Beam&) = default;
};

/// A camera. The default shows all data, seen along the beam axis. The data fill a box (Volume::dataBox()), which may
/// be smaller than the grid: a sector often leaves much of its grid empty.
struct Pose {
    ViewDirection direction;
    Vec3 offsetMm{0, 0, 0};      ///< grid mm, from the data box's centre to the point at the picture's centre
    double magnification = 1.0;  ///< above 0; at 1 the whole box, seen along the beam in parallel projection, fits
    friend bool operator==(const Pose&, const Pose&) = default;
};

/// The view from the probe, whole and uncut.
[[nodiscard]] Viewpoint viewAlongBeam(const Beam& beam);
/// The view along a direction, of the whole volume.
[[nodiscard]] Viewpoint viewpointOf(BeamAxis beam, const ViewDirection& direction);
/// The direction of withinPoles(viewpoint).
[[nodiscard]] ViewDirection directionOf(const Viewpoint& viewpoint);

/// Looks from another direction. The data box's centre keeps its place in the picture.
[[nodiscard]] Pose turnedTo(const Pose& pose, BeamAxis beam, const ViewDirection& direction);

/// The camera of a pose, for a picture of width / height `aspect` (> 0).
[[nodiscard]] CameraPose cameraPoseOf(const Pose& pose, BeamAxis beam, const DataBox& box, Projection projection,
                                      double aspect);
/// The pose after the hand has moved its camera from `before` (as cameraPoseOf() gave it) to `after`, in a picture of
/// width / height `aspect`. What the hand did not change keeps its bits.
[[nodiscard]] Pose movedPose(const Pose& pose, const CameraPose& before, const CameraPose& after, const DataBox& box,
                             double aspect);
/// The pose of fittedPose(). The viewpoint's box fills the picture, or the whole data box if it has none.
[[nodiscard]] Pose wholeVolumePose(const DataBox& box, const Viewpoint& viewpoint, Projection projection,
                                   double aspect);

}  // namespace echolucent
