// What all panes of the window share: from where the study is looked at, what is cut away, and how it looks.
#pragma once

#include <optional>
#include <string_view>

#include "processing/picture/look.h"
#include "processing/scalpel/scalpel_stroke.h"
#include "processing/scene/box.h"
#include "processing/scene/planes.h"
#include "processing/scene/pose.h"
#include "processing/shared_list.h"
#include "processing/viewpoint/cut_surface.h"
#include "processing/volume/volume.h"

namespace echolucent {

/// Who chose the front.
enum class FrontSource {
    person,  ///< chosen in the program
    found,   ///< made on opening, by the search for the near cut
};
/// "person", "found".
[[nodiscard]] std::string_view nameOf(FrontSource source);
[[nodiscard]] std::optional<FrontSource> frontSourceFromName(std::string_view name);

/// Cuts away what lies before it, seen from the side it was made for. It is a plane, a bowed surface that is fixed in
/// the volume, or both. The default cuts nothing.
struct Front {
    /// Depth of the plane: mm behind the volume's foremost point along `direction`, >= 0. 0: no plane.
    double depthMm = 0.0;
    /// The plane lies across this direction and is fixed in the volume. No value: it lies across the pose and turns
    /// with it.
    std::optional<ViewDirection> direction{};
    std::optional<CutSurface> surface{};  ///< the bowed surface
    FrontSource source = FrontSource::person;
    friend bool operator==(const Front&, const Front&) = default;
};

/// The default shows all of the study along the beam, with the look that the program starts with.
struct Scene {
    Pose pose;
    ViewDirection side;  ///< from which the scan is looked into: tube cores run this way
    Front front;
    Look look = lookAtStart();
    Box box;
    Planes planes;
    SharedList<ScalpelStroke> strokes{};  ///< the scalpel's cuts, in the order in which they were drawn
    // What plays. Undo does not count another phase or frame as a step (withShown()).
    int phase = 0;             ///< of a 4D study, counted from 0
    double motionAngle = 0.0;  ///< degrees by which the motion has turned the pose
    friend bool operator==(const Scene&, const Scene&) = default;
};

/// The scene without a plane that is fixed in a direction: if its front still has a plane, the plane lies across the
/// pose. A fixed plane becomes a surface that cuts away the same. If the front has a surface already, each of its nodes
/// moves back to the plane if the plane lies deeper.
[[nodiscard]] Scene withFrontAcrossPose(Scene scene, BeamAxis beam, const VolumeGeometry& geometry);

/// What is wrong with a scene, with its key ("box has a size that is not above 0"): lower case, no full stop. Empty if
/// nothing is wrong.
[[nodiscard]] std::string problemOf(const Scene& scene, BeamAxis beam);

}  // namespace echolucent
