// Grips in a plane: the parts of the render box and of the front that the hand can hold.
#pragma once

#include <QPolygonF>
#include <optional>
#include <vector>

#include "processing/scene/box.h"
#include "processing/viewpoint/box_section.h"
#include "processing/viewpoint/cut_surface.h"
#include "widgets/planes/plane_mapping.h"

namespace echolucent {

/// The box and the front of a scene. Either may be missing. The box limits, the front begins.
struct BoxScene {
    std::optional<OrientedBox> box{};
    std::optional<CutSurface> front{};  ///< a flat one too
    double leastMm = 1.0;               ///< least thickness of the box, > 0
    friend bool operator==(const BoxScene&, const BoxScene&) = default;
};

/// A part that can be dragged.
struct BoxGrip {
    enum class Kind {
        face,    ///< one face moves
        corner,  ///< two faces move
        centre,  ///< the box moves
        turn,    ///< the box turns about its centre, in the plane
        bow,     ///< the front is bowed
        front,   ///< the front moves along its own forward
    };
    Kind kind = Kind::face;
    BoxFace first{}, second{};  ///< the faces that move: `first` of a face or corner, `second` of a corner
    QPointF at;                 ///< logical pixels
};

/// The scene after a drag.
struct BoxDrag {
    OrientedBox box{};     ///< changed by all grips but bow and front
    CutSurface front{};    ///< changed by bow and front
    double frontMm = 0.0;  ///< how far the grip `front` moved the front
};

/// What a plane shows of the scene: polygon of the box with its faces, line of the front, grips.
struct BoxDrawing {
    QPolygonF outline;           ///< closed; empty if the plane misses the box
    std::vector<BoxFace> faces;  ///< edge i, from corner i to the next one, lies on faces[i]
    QPolygonF frontLine;         ///< open; empty if the plane does not cross the front
    std::vector<BoxGrip> grips;  ///< a grip in front of others comes first
};
[[nodiscard]] BoxDrawing boxDrawing(const BoxScene& scene, const PlaneMapping& mapping);

/// The grip under a place; no value if there is none. A face can be held anywhere along its line, and so can the
/// front.
[[nodiscard]] std::optional<BoxGrip> gripAt(const BoxDrawing& drawing, const QPointF& pixel);
/// A grip is held at up to this distance, in logical pixels: targets are 16 pixels wide. A line is held at up to half
/// of it.
inline constexpr double gripReach = 8.0;

/// The scene after a grip was dragged from one pixel to another. `scene` and `mapping` are those at the beginning of
/// the drag.
[[nodiscard]] BoxDrag dragged(const BoxScene& scene, const PlaneMapping& mapping, const BoxGrip& grip,
                              const QPointF& from, const QPointF& to);

}  // namespace echolucent
