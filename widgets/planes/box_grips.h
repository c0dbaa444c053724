// Grips in a plane: the parts of the render box and of the picture's start surface that the hand can hold.
#pragma once

#include <QPolygonF>
#include <optional>
#include <vector>

#include "processing/scene/box.h"
#include "processing/viewpoint/box_section.h"
#include "processing/viewpoint/cut_surface.h"
#include "widgets/planes/plane_mapping.h"

namespace echolucent {

/// The box and the start surface of a view. Either may be missing.
struct BoxScene {
    std::optional<OrientedBox> box{};
    BoxFace front{2, -1};  ///< of the box
    /// The surface that the picture begins at: the cut's own, or, if a box is on, the flat one that a bow would bend.
    std::optional<CutSurface> start{};
    bool startIsCut = false;  ///< whether the start surface already cuts; false: it is only the front of the box
    double leastMm = 1.0;     ///< least thickness of the box, > 0
    friend bool operator==(const BoxScene&, const BoxScene&) = default;
};

/// A part that can be dragged.
struct BoxGrip {
    enum class Kind {
        face,    ///< one face moves
        corner,  ///< two faces move
        centre,  ///< the box moves
        turn,    ///< the box turns about its centre, in the plane
        bow,     ///< the start surface is bowed
        start,   ///< the start surface moves along its forward
    };
    Kind kind = Kind::face;
    BoxFace first{}, second{};  ///< the faces that move: `first` of a face or corner, `second` of a corner
    QPointF at;                 ///< logical pixels
};

/// The scene after a drag.
struct BoxDrag {
    OrientedBox box{};     ///< changed by all grips but bow and start
    CutSurface start{};    ///< changed by bow and start
    double startMm = 0.0;  ///< how far the grip `start` moved the surface
};

/// What a plane shows of the scene: polygon of the box with its faces, line of the start surface, grips.
struct BoxDrawing {
    QPolygonF outline;           ///< closed; empty if the plane misses the box
    std::vector<BoxFace> faces;  ///< edge i, from corner i to the next one, lies on faces[i]
    QPolygonF startLine;         ///< open; empty if the plane does not cross the surface
    bool startIsCut = false;     ///< as in BoxScene
    std::vector<BoxGrip> grips;  ///< a grip in front of others comes first
};
[[nodiscard]] BoxDrawing boxDrawing(const BoxScene& scene, const PlaneMapping& mapping);

/// The grip under a place; no value if there is none. A face can be held anywhere along its line, and so can a start
/// surface that cuts.
[[nodiscard]] std::optional<BoxGrip> gripAt(const BoxDrawing& drawing, const QPointF& pixel);
/// A grip is held at up to this distance, in logical pixels: targets are 16 pixels wide. A line is held at up to half
/// of it.
inline constexpr double gripReach = 8.0;

/// The scene after a grip was dragged from one pixel to another. `scene` and `mapping` are those at the beginning of
/// the drag.
[[nodiscard]] BoxDrag dragged(const BoxScene& scene, const PlaneMapping& mapping, const BoxGrip& grip,
                              const QPointF& from, const QPointF& to);

}  // namespace echolucent
