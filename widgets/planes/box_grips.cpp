#include "widgets/planes/box_grips.h"

#include <QLineF>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "processing/document/box_editing.h"

namespace echolucent {

namespace {

constexpr double turnStalk = 24.0;       // logical pixels from the box to its turning grip
constexpr double frontLineStep = 4.0;    // between points of the front's line
constexpr double leastMiddlePart = 0.3;  // least share of a surface's forward that must lie in the plane

/// The front's line in the plane. Each of its points is found by going along the surface's forward, projected
/// onto the plane, to the first place that the surface does not cut away. Empty if the surface looks too much across
/// the plane (leastMiddlePart), or if fewer than two points are found.
QPolygonF frontLineOf(const CutSurface& surface, const PlaneMapping& mapping) {
    const ViewFrame& frame = mapping.view.frame;
    const Vec3 inPlane = surface.frame.forward - frame.forward * frame.forward.dot(surface.frame.forward);
    if (length(inPlane) < leastMiddlePart) return {};
    const Vec3 along = normalized(inPlane), across = frame.forward.cross(along);
    const double step = mapping.mmPerPixel();
    const double reach = std::hypot(mapping.size.width(), mapping.size.height()) * step;
    QPolygonF line;
    for (double mm = -reach / 2; mm <= reach / 2; mm += frontLineStep * step) {
        const Vec3 point = mapping.view.centreMm + across * mm - along * reach;
        if (const auto left = surface.firstLeft(point, along, {0.0, 2.0 * reach}); left && left->begin > 0.0)
            line << mapping.seenAt(point + along * left->begin);
    }
    return line.size() < 2 ? QPolygonF() : line;
}

QPointF centroidOf(const QPolygonF& polygon) {
    QPointF sum;
    for (const QPointF& corner : polygon) sum += corner;
    return sum / std::max<qsizetype>(1, polygon.size());
}

QLineF edgeOf(const QPolygonF& outline, qsizetype i) { return {outline[i], outline[(i + 1) % outline.size()]}; }

void addBoxGrips(BoxDrawing& drawing, const PlaneMapping& mapping, const OrientedBox& box) {
    const QPointF centre = centroidOf(drawing.outline);
    const qsizetype count = drawing.outline.size();
    qsizetype rightmost = 0;
    for (qsizetype i = 1; i < count; ++i)
        if (edgeOf(drawing.outline, i).center().x() > edgeOf(drawing.outline, rightmost).center().x()) rightmost = i;
    const QLineF right = edgeOf(drawing.outline, rightmost);
    const QPointF outwards = mapping.wayOf(outwardNormal(box, drawing.faces[static_cast<std::size_t>(rightmost)]));
    const double size = std::hypot(outwards.x(), outwards.y());
    if (size > 0.0)
        drawing.grips.push_back({BoxGrip::Kind::turn, {}, {}, right.center() + outwards * (turnStalk / size)});
    for (qsizetype i = 0; i < count; ++i) {
        const auto before = static_cast<std::size_t>((i + count - 1) % count);
        drawing.grips.push_back({BoxGrip::Kind::corner, drawing.faces[before],
                                 drawing.faces[static_cast<std::size_t>(i)], drawing.outline[i]});
    }
    drawing.grips.push_back({BoxGrip::Kind::centre, {}, {}, centre});
    for (qsizetype i = 0; i < count; ++i)
        drawing.grips.push_back(
            {BoxGrip::Kind::face, drawing.faces[static_cast<std::size_t>(i)], {}, edgeOf(drawing.outline, i).center()});
}

/// Puts the bow's grip on the front's line, at the point in the pane with the largest bow, away from grips of the box.
/// No grip if bowAt() is 0.1 or less everywhere.
void addBowGrip(BoxDrawing& drawing, const PlaneMapping& mapping, const CutSurface& surface) {
    double most = 0.1;
    std::optional<QPointF> middle;
    const QRectF pane(QPointF(0, 0), QSizeF(mapping.size));
    for (const QPointF& place : drawing.frontLine) {
        const double share = bowAt(surface, mapping.gridAt(place));
        const auto near = [&](const BoxGrip& grip) { return QLineF(grip.at, place).length() < 3.0 * gripReach; };
        if (share <= most || !pane.contains(place) || std::ranges::any_of(drawing.grips, near)) continue;
        most = share;
        middle = place;
    }
    if (middle) drawing.grips.insert(drawing.grips.begin(), {BoxGrip::Kind::bow, {}, {}, *middle});
}

double distanceTo(const QLineF& line, const QPointF& pixel) {
    const QPointF way = line.p2() - line.p1(), from = pixel - line.p1();
    const double squared = QPointF::dotProduct(way, way);
    const double share = squared > 0.0 ? std::clamp(QPointF::dotProduct(from, way) / squared, 0.0, 1.0) : 0.0;
    return QLineF(line.p1() + way * share, pixel).length();
}

}  // namespace

BoxDrawing boxDrawing(const BoxScene& scene, const PlaneMapping& mapping) {
    BoxDrawing drawing;
    if (scene.box) {
        const BoxSection section = sectionOf(*scene.box, mapping.view.centreMm, mapping.view.frame.forward);
        for (const Vec3& corner : section.corners) drawing.outline << mapping.seenAt(corner);
        drawing.faces = section.faces;
        if (!drawing.outline.isEmpty()) addBoxGrips(drawing, mapping, *scene.box);
    }
    if (scene.front) {
        drawing.frontLine = frontLineOf(*scene.front, mapping);
        addBowGrip(drawing, mapping, *scene.front);
    }
    return drawing;
}

std::optional<BoxGrip> gripAt(const BoxDrawing& drawing, const QPointF& pixel) {
    for (const BoxGrip& grip : drawing.grips)
        if (QLineF(grip.at, pixel).length() <= gripReach) return grip;
    for (qsizetype i = 0; i < drawing.outline.size(); ++i)
        if (distanceTo(edgeOf(drawing.outline, i), pixel) <= gripReach / 2)
            return BoxGrip{BoxGrip::Kind::face, drawing.faces[static_cast<std::size_t>(i)], {}, pixel};
    for (qsizetype i = 0; i + 1 < drawing.frontLine.size(); ++i)
        if (distanceTo({drawing.frontLine[i], drawing.frontLine[i + 1]}, pixel) <= gripReach / 2)
            return BoxGrip{BoxGrip::Kind::front, {}, {}, pixel};
    return std::nullopt;
}

BoxDrag dragged(const BoxScene& scene, const PlaneMapping& mapping, const BoxGrip& grip, const QPointF& from,
                const QPointF& to) {
    const Vec3 moved = mapping.gridAt(to) - mapping.gridAt(from);
    BoxDrag next;
    if (scene.box) next.box = *scene.box;
    if (scene.front) next.front = *scene.front;
    const auto moveFace = [&](const BoxFace& face) {
        next.box = withFaceMoved(next.box, face, outwardNormal(*scene.box, face).dot(moved), scene.leastMm);
    };
    switch (grip.kind) {
        case BoxGrip::Kind::face: moveFace(grip.first); break;
        case BoxGrip::Kind::corner:
            moveFace(grip.first);
            moveFace(grip.second);
            break;
        case BoxGrip::Kind::centre: next.box.centreMm += moved; break;
        case BoxGrip::Kind::turn: {
            const QPointF centre = mapping.seenAt(scene.box->centreMm), a = from - centre, b = to - centre;
            const double radians = std::atan2(a.x() * b.y() - a.y() * b.x(), QPointF::dotProduct(a, b));
            next.box = turnedAbout(*scene.box, mapping.view.frame.forward, radians * 180.0 / std::numbers::pi);
            break;
        }
        case BoxGrip::Kind::bow: {
            const double share = bowAt(*scene.front, mapping.gridAt(grip.at));
            next.front = bowed(*scene.front, scene.front->frame.forward.dot(moved) / share);
            break;
        }
        case BoxGrip::Kind::front:
            next.frontMm = scene.front->frame.forward.dot(moved);
            next.front.depthMm.change([mm = static_cast<float>(next.frontMm)](std::vector<float>& depths) {
                for (float& depth : depths) depth += mm;
            });
            break;
    }
    return next;
}

}  // namespace echolucent
