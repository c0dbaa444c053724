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

/// A surface fixed in the volume, flat or bowed. What lies before it, seen from the side it was made for, is cut away
/// from wherever one looks. The default cuts nothing.
struct Front {
    /// Of a flat front: mm behind the volume's foremost point along `direction`, >= 0. 0: there is no flat front.
    double depthMm = 0.0;
    ViewDirection direction{};            ///< of a flat front, which lies across it; relative to the beam
    std::optional<CutSurface> surface{};  ///< a bowed front. A file may state both, and then both cut
    FrontSource source = FrontSource::person;
    friend bool operator==(const Front&, const Front&) = default;
};

/// Whether there is a front.
[[nodiscard]] bool cuts(const Front& front);
/// A flat front across a direction, `depthMm` behind the volume's foremost point along it; none if that is 0 or less.
[[nodiscard]] Front frontAcross(const ViewDirection& direction, double depthMm,
                                FrontSource source = FrontSource::person);
/// How deep the front lies: mm behind the volume's foremost point along its own forward. For a bowed front that is its
/// node nearest to the volume's centre, and may be below 0. 0 if there is no front.
[[nodiscard]] double depthOf(const Front& front, const VolumeGeometry& geometry);
/// The front moved along its own forward until depthOf() is `depthMm`, as a person's front. A flat front stops at 0,
/// and then there is none.
[[nodiscard]] Front movedTo(Front front, double depthMm, const VolumeGeometry& geometry);
/// The front moved by `mm` along its own forward, as far as the volume reaches; a flat one stays 0.1 mm deep at least,
/// so that a hand still holds it. The front must cut.
[[nodiscard]] Front movedBy(const Front& front, double mm, BeamAxis beam, const VolumeGeometry& geometry);
/// A flat front across a view, as a person's front. It passes through the place at which the line through `pointMm`
/// along the view meets the front. If the line runs along the front or comes from behind it, it passes through the
/// place of the front nearest to `pointMm`. Its depth is a whole number of tenths of a millimetre, and at least
/// something of the volume is left. The front must cut.
[[nodiscard]] Front acrossView(const Front& front, const Viewpoint& view, const Vec3& pointMm,
                               const VolumeGeometry& geometry);
/// The way that the front's forward points, grid mm. For a front that does not cut: along the beam.
[[nodiscard]] Vec3 forwardOf(const Front& front, BeamAxis beam);

/// The default shows all of the study along the beam, with the look that the program starts with.
struct Scene {
    Pose pose;
    ViewDirection side;  ///< from which the scan is looked into: tube cores run this way
    Front front;
    Look look = lookAtStart();
    /// (0, 1]: a factor on the look's brightness. Below 1 if opening found that the scan begins with an overexposed
    /// face (exposureFor()).
    double exposure = 1.0;
    Box box;
    Planes planes;
    SharedList<ScalpelStroke> strokes{};  ///< the scalpel's cuts, in the order in which they were drawn
    // What plays. Undo does not count another phase or frame as a step (withShown()).
    int phase = 0;             ///< of a 4D study, counted from 0
    double motionAngle = 0.0;  ///< degrees by which the motion has turned the pose
    friend bool operator==(const Scene&, const Scene&) = default;
};

/// The view behind the scene's front.
[[nodiscard]] Viewpoint behindFront(Viewpoint view, const Front& front);
/// The look as pictures of the volume show it: its brightness times the exposure.
[[nodiscard]] Look shownLook(const Scene& scene);

/// What is wrong with a scene, with its key ("box has a size that is not above 0"): lower case, no full stop. Empty if
/// nothing is wrong.
[[nodiscard]] std::string problemOf(const Scene& scene);

}  // namespace echolucent
