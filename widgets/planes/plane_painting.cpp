// How the pane of a plane is painted.
#include <QPainter>
#include <QPainterPath>
#include <array>
#include <cmath>

#include "widgets/picture_labels/measurement_drawing.h"
#include "widgets/picture_labels/rimmed_text.h"
#include "widgets/planes/plane_colours.h"
#include "widgets/planes/plane_pane.h"

namespace echolucent {

namespace {

constexpr double gapAtReference = 9.0, referenceRadius = 5.0;
constexpr int rimShade = 40;  // of 255

QString letterOf(PlaneName plane) { return QString(QLatin1Char(nameOf(plane).front())); }

/// Faces and corners are squares, the centre a cross in a square, the turning grip a ring, the bow a diamond.
void paintGrip(QPainter& painter, const BoxGrip& grip) {
    const bool bow = grip.kind == BoxGrip::Kind::bow, turn = grip.kind == BoxGrip::Kind::turn;
    const double half = grip.kind == BoxGrip::Kind::corner ? 3.0 : bow ? 6.0 : 4.0;
    QPainterPath path;
    if (bow)
        path.addPolygon(QPolygonF({grip.at + QPointF(0, -half), grip.at + QPointF(half, 0), grip.at + QPointF(0, half),
                                   grip.at + QPointF(-half, 0)}));
    else if (turn)
        path.addEllipse(grip.at, half, half);
    else
        path.addRect(QRectF(grip.at - QPointF(half, half), QSizeF(2 * half, 2 * half)));
    path.closeSubpath();
    painter.setPen(QPen(QColor(0, 0, 0, 200), 3.0));
    painter.drawPath(path);
    painter.setPen(QPen(bow ? frontColour() : boxColour(), 1.5));
    painter.setBrush(turn ? QBrush(Qt::NoBrush) : QBrush(QColor(0, 0, 0, 120)));
    painter.drawPath(path);
    painter.setBrush(Qt::NoBrush);
    if (grip.kind != BoxGrip::Kind::centre) return;
    painter.drawLine(grip.at - QPointF(2 * half, 0), grip.at + QPointF(2 * half, 0));
    painter.drawLine(grip.at - QPointF(0, 2 * half), grip.at + QPointF(0, 2 * half));
}

}  // namespace

void PlanePane::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    // An image with just the pane's pixels covers all that lies behind it.
    const bool covered = m_scene && QSizeF(m_image.size()) == QSizeF(size()) * devicePixelRatioF();
    if (!covered) painter.fillRect(rect(), Qt::black);
    if (!m_scene) return;
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    if (!m_image.isNull()) painter.drawImage(rect(), m_image);
    paintLines(painter);
    paintBox(painter);
    paintMeasured(painter);
    if (m_pointerAtRim || m_drag == Drag::turn) paintRim(painter);
    paintWords(painter);
    const double width = hasFocus() ? 3.0 : 1.5;
    painter.setPen(QPen(colourOf(m_plane), width));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(QRectF(rect()).adjusted(width / 2, width / 2, -width / 2, -width / 2));
    if (m_dimmed) painter.fillRect(rect(), oldPictureShadeColour());
}

/// Draws the lines of the other planes and the reference point.
void PlanePane::paintLines(QPainter& painter) const {
    const Planes& planes = m_scene->planes;
    const ViewFrame frame = mapping().view.frame;
    const QPointF centre = referencePixel();
    const double reach = std::hypot(width(), height()) + std::hypot(centre.x(), centre.y());
    for (const PlaneName other : allPlaneNames) {
        if (other == m_plane) continue;
        const Vec3 along = frame.forward.cross(frameOf(other, planes, m_scene->beam).forward);
        const QPointF way(frame.right.dot(along), frame.down.dot(along));
        QColor colour = colourOf(other);
        for (const double sign : {-1.0, 1.0}) {
            const QLineF line(centre + way * (sign * gapAtReference), centre + way * (sign * reach));
            painter.setPen(QPen(QColor(0, 0, 0, 130), 3.0));
            painter.drawLine(line);
            painter.setPen(QPen(colour, 1.25));
            painter.drawLine(line);
        }
    }
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(QColor(0, 0, 0, 160), 3.0));
    painter.drawEllipse(centre, referenceRadius, referenceRadius);
    painter.setPen(QPen(coloursOverPictures().text, 1.25));
    painter.drawEllipse(centre, referenceRadius, referenceRadius);
}

/// Draws the box, then the front's line and the grips.
void PlanePane::paintBox(QPainter& painter) const {
    const BoxDrawing& shown = drawing();
    painter.setBrush(Qt::NoBrush);
    const auto paintLine = [&](const QPolygonF& line, const QColor& colour, double width, Qt::PenStyle style) {
        painter.setPen(QPen(QColor(0, 0, 0, 150), width + 2.0));
        painter.drawPolyline(line);
        painter.setPen(QPen(colour, width, style));
        painter.drawPolyline(line);
    };
    const qsizetype count = shown.outline.size();
    for (qsizetype i = 0; i < count; ++i) {
        const QPolygonF edge({shown.outline[i], shown.outline[(i + 1) % count]});
        paintLine(edge, boxColour(), 1.5, Qt::SolidLine);
    }
    if (!shown.frontLine.isEmpty()) paintLine(shown.frontLine, frontColour(), 2.0, Qt::DashLine);
    for (const BoxGrip& grip : shown.grips) paintGrip(painter, grip);
}

void PlanePane::paintMeasured(QPainter& painter) const {
    std::vector<ShownMeasurement> shown = m_scene->measurements;
    if (m_marking) shown.push_back(*m_marking);
    if (!shown.empty()) paintMeasurements(painter, placedInPlane(shown, mapping().view, m_scene->unitMm), size());
}

void PlanePane::paintWords(QPainter& painter) const {
    const QColor words = coloursOverPictures().text;
    QFont font = painter.font();
    font.setBold(true);
    font.setPixelSize(18);
    painter.setFont(font);
    paintRimmedText(painter, {10, 23}, letterOf(m_plane), colourOf(m_plane));
    font.setPixelSize(12);
    painter.setFont(font);
    const QFontMetricsF metrics(font);
    const double mm = frameOf(m_plane, m_scene->planes, m_scene->beam).forward.dot(m_scene->planes.offsetMm);
    const QString place = (m_scene->lengthsKnown ? tr("%1 mm") : tr("%1 mm (guess)")).arg(mm, 0, 'f', 1);
    paintRimmedText(painter, {10, height() - 10.0}, QString(place).replace(QLatin1Char('-'), QChar(0x2212)), words);
    const std::array<QPointF, 4> places{
        QPointF(8, height() / 2.0),
        QPointF(width() - 8 - metrics.horizontalAdvance(m_scene->letters[1]), height() / 2.0),
        QPointF((width() - metrics.horizontalAdvance(m_scene->letters[2])) / 2, 20),
        QPointF((width() - metrics.horizontalAdvance(m_scene->letters[3])) / 2, height() - 10.0)};
    for (std::size_t i = 0; i < places.size(); ++i)
        if (!m_scene->letters[i].isEmpty()) paintRimmedText(painter, places[i], m_scene->letters[i], words);
}

/// Shades the whole rim: there a drag turns the planes.
void PlanePane::paintRim(QPainter& painter) const {
    QPainterPath path;
    path.addRect(rect());
    path.addRoundedRect(QRectF(rect()).adjusted(rim, rim, -rim, -rim), rim / 2, rim / 2);
    QColor shade = coloursOverPictures().text;
    shade.setAlpha(rimShade);
    painter.fillPath(path, shade);
}

}  // namespace echolucent
