// What of the render box, and of the surface that the picture begins at, the hand can hold in a plane.
#pragma once

#include <QPolygonF>
#include <optional>
#include <vector>

#include "processing/box_section.h"
#include "processing/cut_surface.h"
#include "processing/document/box.h"
#include "widgets/planes/plane_mapping.h"

namespace echolucent {

/// The box and the start surface of a view; either may not be there.
struct BoxScene {
    std::optional<OrientedBox> box{};
    BoxFace front{2, -1};  ///< of the box
    /// What the picture begins at: the cut's own surface, or, where a box is on, the flat one that would be bowed.
    std::optional<CutSurface> start{};
    bool startIsCut = false;  ///< whether the start surface cuts already, and is no mere front of the box
    double leastMm = 1.0;     ///< thickness of the box, > 0
    friend bool operator==(const BoxScene&, const BoxScene&) = default;
};

/// Something that can be dragged.
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
    BoxFace first{}, second{};  ///< of a face and a corner
    QPointF at;                 ///< logical pixels
};

/// What the hand makes of the scene.
struct BoxDrag {
    OrientedBox box{};     ///< of all grips but bow and start
    CutSurface start{};    ///< of bow and start
    double startMm = 0.0;  ///< of start: by how much it moved
};

/// What a plane shows of the scene: polygon of the box with its faces, line of the start surface, grips.
struct BoxDrawing {
    QPolygonF outline;           ///< closed; empty where the plane misses the box
    std::vector<BoxFace> faces;  ///< edge i, from corner i to the next one, lies on faces[i]
    QPolygonF startLine;         ///< open; empty where the plane does not meet the surface across
    bool startIsCut = false;     ///< as in BoxScene
    std::vector<BoxGrip> grips;  ///< those that lie before others come first
};
[[nodiscard]] BoxDrawing boxDrawing(const BoxScene& scene, const PlaneMapping& mapping);

/// The grip under a place; a face is held anywhere along its line.
[[nodiscard]] std::optional<BoxGrip> gripAt(const BoxDrawing& drawing, const QPointF& pixel);
/// The least distance, logical pixels, at which a grip is held: targets are 16 pixels wide.
inline constexpr double gripReach = 8.0;

/// The scene after a grip was dragged from one pixel to another, counted from the scene in which the drag began.
[[nodiscard]] BoxDrag dragged(const BoxScene& scene, const PlaneMapping& mapping, const BoxGrip& grip,
                              const QPointF& from, const QPointF& to);

}  // namespace echolucent
