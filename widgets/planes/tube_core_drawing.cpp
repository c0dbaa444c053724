#include "widgets/planes/tube_core_drawing.h"

#include <QPainter>
#include <QPolygonF>
#include <algorithm>
#include <cmath>
#include <vector>

#include "widgets/picture_labels/rimmed_text.h"
#include "widgets/tube_core_colours.h"

namespace echolucent {

namespace {

constexpr double chosenWidth = 2.5, rimOfLine = 1.5;
constexpr double shareOfWidth = 0.75;  // lines in planes are thinner than in 3D: there are more of them
constexpr int numberPixels = 13;

/// A tube core as a plane shows it, in pixels.
struct Drawn {
    const TubeCoreMark* mark;
    QPolygonF outline;
    std::optional<QPointF> surface;
};

std::vector<Drawn> drawnIn(const PlaneTubeCores& tubeCores, const PlaneMapping& mapping) {
    std::vector<Drawn> all;
    if (!tubeCores.marks) return all;
    for (const TubeCoreMark& mark : tubeCores.marks->marks) {
        const auto shown = shownInPlane(*tubeCores.marks, mark, mapping.view.centreMm, mapping.view.frame.forward);
        if (!shown) continue;
        Drawn drawn{&mark, {}, {}};
        for (const Vec3& corner : shown->outlineMm) drawn.outline << mapping.seenAt(corner);
        if (shown->surfaceMm) drawn.surface = mapping.seenAt(*shown->surfaceMm);
        all.push_back(std::move(drawn));
    }
    // The heavier lies over the lighter, and the chosen one over all.
    std::ranges::stable_sort(
        all, {}, [&](const Drawn& each) { return each.mark->number == tubeCores.chosen ? 2.0 : each.mark->share; });
    return all;
}

/// Half of the short line at a surface: across the tube core, in the plane.
QPointF halfAcross(const TubeCoreMarks& marks, const PlaneMapping& mapping) {
    const QPointF right = mapping.wayOf(marks.axes.right), down = mapping.wayOf(marks.axes.down);
    const QPointF longer = QPointF::dotProduct(right, right) >= QPointF::dotProduct(down, down) ? right : down;
    const double length = std::hypot(longer.x(), longer.y());
    constexpr double shortest = 3.0;  // pixels
    return length > 0.0 ? longer / length * std::max(shortest, marks.halfWidthMm / mapping.mmPerPixel()) : QPointF();
}

}  // namespace

void paintTubeCores(QPainter& painter, const PlaneTubeCores& tubeCores, const PlaneMapping& mapping) {
    if (!tubeCores.marks) return;
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    const ThemeColours& colours = coloursOverPictures();
    const QPointF across = halfAcross(*tubeCores.marks, mapping);
    for (const Drawn& each : drawnIn(tubeCores, mapping)) {
        const bool chosen = each.mark->number == tubeCores.chosen;
        const double width = chosen ? chosenWidth : shareOfWidth * tubeCoreWidth(each.mark->share);
        const auto pen = [&](const QColor& colour, double wide) {
            return QPen(colour, wide, Qt::SolidLine, Qt::FlatCap, Qt::MiterJoin);
        };
        if (chosen || each.mark->share > 0.0) {
            painter.setPen(pen(QColor(0, 0, 0, 130), width + rimOfLine));
            painter.drawPolygon(each.outline);
        }
        painter.setPen(pen(chosen ? colours.text : tubeCoreColour(each.mark->share, colours), width));
        painter.drawPolygon(each.outline);
        if (!each.surface) continue;
        for (const auto& [colour, wide] : {std::pair{QColor(0, 0, 0, 160), 4.5}, std::pair{QColor(Qt::white), 2.5}}) {
            painter.setPen(pen(colour, wide));
            painter.drawLine(*each.surface - across, *each.surface + across);
        }
    }
    if (const TubeCoreMark* chosen = tubeCores.chosen ? tubeCores.marks->of(*tubeCores.chosen) : nullptr) {
        for (const Drawn& each : drawnIn(tubeCores, mapping)) {
            if (each.mark != chosen) continue;
            QFont font = painter.font();
            font.setBold(true);
            font.setPixelSize(numberPixels);
            painter.setFont(font);
            const QRectF box = each.outline.boundingRect();
            const QString number = QString::number(chosen->number);
            const double x = box.right() + 5.0;
            const double y = each.surface ? each.surface->y() + numberPixels / 3.0 : box.center().y();
            paintRimmedText(painter, {x, y}, number, colours.text);
        }
    }
    painter.restore();
}

std::optional<int> tubeCoreAt(const PlaneTubeCores& tubeCores, const PlaneMapping& mapping, const QPointF& pixel,
                              double reach) {
    std::optional<int> nearest;
    double least = 0.0;
    for (const Drawn& each : drawnIn(tubeCores, mapping)) {
        QPolygonF outline = each.outline;
        outline << outline.front();
        const bool inside = outline.containsPoint(pixel, Qt::OddEvenFill);
        double distance = inside ? 0.0 : reach;
        for (qsizetype i = 0; !inside && i + 1 < outline.size(); ++i) {
            const QPointF edge = outline[i + 1] - outline[i], from = pixel - outline[i];
            const double squared = QPointF::dotProduct(edge, edge);
            const double share = squared > 0.0 ? std::clamp(QPointF::dotProduct(from, edge) / squared, 0.0, 1.0) : 0.0;
            const QPointF apart = from - edge * share;
            distance = std::min(distance, std::hypot(apart.x(), apart.y()));
        }
        if (distance >= reach) continue;
        // Outlines may lie over each other: the one whose middle line is nearer wins.
        const QPointF middle = each.outline.boundingRect().center() - pixel;
        const QPointF along = mapping.wayOf(tubeCores.marks->axes.forward);
        const double way = std::hypot(along.x(), along.y());
        const double off = way * mapping.mmPerPixel() > 0.5
                               ? std::abs(middle.x() * along.y() - middle.y() * along.x()) / way
                               : std::hypot(middle.x(), middle.y());
        if (nearest && off >= least) continue;
        least = off;
        nearest = each.mark->number;
    }
    return nearest;
}

}  // namespace echolucent
