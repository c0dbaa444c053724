// How a pane of a plane is painted.
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <array>
#include <cmath>

#include "widgets/planes/plane_colours.h"
#include "widgets/planes/plane_pane.h"

namespace echolucent {

namespace {

constexpr double gapAtReference = 9.0, referenceRadius = 5.0;
const QColor words(0xd8, 0xdd, 0xe2), rimShade(0xd8, 0xdd, 0xe2, 40);

QString textOf(PlaneName plane) { return QString(QLatin1Char(nameOf(plane).front())); }

/// A text with a dark rim, so that it is read over bright tissue too.
void paintText(QPainter& painter, const QPointF& baseline, const QString& text, const QColor& colour) {
    QPainterPath path;
    path.addText(baseline, painter.font(), text);
    painter.strokePath(path, QPen(QColor(0, 0, 0, 200), 3.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.fillPath(path, colour);
}

}  // namespace

void PlanePane::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), Qt::black);
    if (!m_scene) return;
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    if (!m_image.isNull()) painter.drawImage(rect(), m_image);
    paintLines(painter);
    if (m_pointerAtRim || m_drag == Drag::turn) paintRim(painter);
    paintWords(painter);
    const double width = hasFocus() ? 3.0 : 1.5;
    painter.setPen(QPen(colourOf(m_plane), width));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(QRectF(rect()).adjusted(width / 2, width / 2, -width / 2, -width / 2));
}

/// Where the other planes cross this one, and the reference point.
void PlanePane::paintLines(QPainter& painter) const {
    const Planes& planes = m_scene->planes;
    const ViewFrame frame = view().frame;
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
    painter.setPen(QPen(words, 1.25));
    painter.drawEllipse(centre, referenceRadius, referenceRadius);
}

void PlanePane::paintWords(QPainter& painter) const {
    QFont font = painter.font();
    font.setBold(true);
    font.setPixelSize(18);
    painter.setFont(font);
    paintText(painter, {10, 23}, textOf(m_plane), colourOf(m_plane));
    font.setPixelSize(12);
    painter.setFont(font);
    const QFontMetricsF metrics(font);
    const double mm = frameOf(m_plane, m_scene->planes, m_scene->beam).forward.dot(m_scene->planes.offsetMm);
    const QString place =
        m_scene->lengthsKnown ? tr("%1 mm").arg(mm, 0, 'f', 1) : tr("%1 voxels").arg(mm / m_scene->unitMm, 0, 'f', 0);
    paintText(painter, {10, height() - 10.0}, QString(place).replace(QLatin1Char('-'), QChar(0x2212)), words);
    const std::array<QPointF, 4> places{
        QPointF(8, height() / 2.0),
        QPointF(width() - 8 - metrics.horizontalAdvance(m_scene->letters[1]), height() / 2.0),
        QPointF((width() - metrics.horizontalAdvance(m_scene->letters[2])) / 2, 20),
        QPointF((width() - metrics.horizontalAdvance(m_scene->letters[3])) / 2, height() - 10.0)};
    for (std::size_t i = 0; i < places.size(); ++i)
        if (!m_scene->letters[i].isEmpty()) paintText(painter, places[i], m_scene->letters[i], words);
}

/// The rim under the pointer shows that it turns the planes.
void PlanePane::paintRim(QPainter& painter) const {
    QPainterPath path;
    path.addRect(rect());
    path.addRoundedRect(QRectF(rect()).adjusted(rim, rim, -rim, -rim), rim / 2, rim / 2);
    painter.fillPath(path, rimShade);
}

}  // namespace echolucent
