// From where a view looks at the volume, in values that mean the same for every study and every shape of a picture.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "processing/picture/camera_pose.h"
#include "processing/viewpoint/viewpoint.h"

namespace echolucent {

/// Who said along which way sound travelled.
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

/// A direction of looking, relative to the beam axis: the angles of Viewpoint, degrees. Where all are 0, it is along
/// that axis.
struct ViewDirection {
    double azimuth = 0.0;
    double elevation = 0.0;  ///< [-90, 90]
    double roll = 0.0;
    friend bool operator==(const ViewDirection&, const ViewDirection&) = default;
};

/// The way along which sound travelled: the default view direction, seen from the probe.
struct Beam {
    BeamAxis axis = BeamAxis::plusZ;
    BeamSource source = BeamSource::assumed;
    ViewDirection lean{};  ///< of the beam itself, where a file says that it leans against its axis
    friend bool operator==(const Beam&, const Beam&) = default;
};

/// A camera. The default shows all data, seen along the beam axis. What is data is a box (Volume::dataBox()), and not
/// the whole grid: a sector often leaves much of its grid empty.
struct Pose {
    ViewDirection direction;
    Vec3 offsetMm{0, 0, 0};      ///< from the data box's centre to the point seen at the picture's centre, grid mm
    double magnification = 1.0;  ///< above 0; at 1 the whole box, seen along the beam in parallel projection, fits
    friend bool operator==(const Pose&, const Pose&) = default;
};

/// The view from the probe, whole and uncut.
[[nodiscard]] Viewpoint viewAlongBeam(const Beam& beam);
/// A view's direction, beam and near cut (mm behind the volume's foremost point along the view, >= 0) in one value.
[[nodiscard]] Viewpoint viewpointOf(BeamAxis beam, const ViewDirection& direction, double nearCutMm);
[[nodiscard]] ViewDirection directionOf(const Viewpoint& viewpoint);

/// Looks from another direction; the data box's centre keeps its place in the picture.
[[nodiscard]] Pose turnedTo(const Pose& pose, BeamAxis beam, const ViewDirection& direction);

/// The camera of a pose, for a picture of width / height `aspect` (> 0).
[[nodiscard]] CameraPose cameraPoseOf(const Pose& pose, BeamAxis beam, double nearCutMm, const DataBox& box,
                                      Projection projection, double aspect);
/// The pose after the hand has moved its camera from `before` (which cameraPoseOf() gave) to `after`, in a picture of
/// that aspect. What the hand did not change keeps its bits.
[[nodiscard]] Pose movedPose(const Pose& pose, const CameraPose& before, const CameraPose& after, const DataBox& box,
                             double aspect);
/// The pose of fittedPose(): the viewpoint's box, or the whole data box where it has none, fills the picture.
[[nodiscard]] Pose wholeVolumePose(const DataBox& box, const Viewpoint& viewpoint, Projection projection,
                                   double aspect);

}  // namespace echolucent
