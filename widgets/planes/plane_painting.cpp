// How the pane of a plane is painted.
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
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

/// The foot of the probe: half a disc at the edge through which sound came, with `word` beside it.
void paintProbe(QPainter& painter, const QSizeF& pane, const QPointF& towards, const QString& word) {
    constexpr double radius = 8.0, beside = 3.0, border = 8.0;
    const QPointF middle(pane.width() / 2.0, pane.height() / 2.0);
    const double across = std::abs(towards.x()) / middle.x(), down = std::abs(towards.y()) / middle.y();
    const bool atSide = across > down;
    const QPointF at = middle + towards / std::max(across, down);
    const int start = atSide ? (towards.x() < 0.0 ? -90 : 90) : (towards.y() < 0.0 ? 180 : 0);
    painter.setPen(QPen(QColor(0, 0, 0, 200), 1.5));
    painter.setBrush(coloursOverPictures().text);
    constexpr int sixteenths = 16;  // Qt's units of a degree
    painter.drawChord(QRectF(at - QPointF(radius, radius), QSizeF(2 * radius, 2 * radius)), start * sixteenths,
                      180 * sixteenths);
    if (word.isEmpty()) return;
    const QFontMetricsF metrics(painter.font());
    const QSizeF half(metrics.horizontalAdvance(word) / 2.0, metrics.ascent() / 2.0);
    const QPointF inwards = atSide ? QPointF(towards.x() < 0.0 ? 1 : -1, 0) : QPointF(0, towards.y() < 0.0 ? 1 : -1);
    QPointF centre = at + inwards * (radius + beside + (atSide ? half.width() : half.height()));
    centre.setX(std::max(half.width() + border, std::min(centre.x(), pane.width() - half.width() - border)));
    centre.setY(std::max(half.height() + border, std::min(centre.y(), pane.height() - half.height() - border)));
    paintRimmedText(painter, centre + QPointF(-half.width(), half.height()), word, coloursOverPictures().text);
}

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
    paintTubeCores(painter, m_tubeCores, mapping());
    paintLines(painter);
    paintBox(painter);
    paintMeasured(painter, true);
    if (m_pointerAtRim || m_drag == Drag::turn) paintRim(painter);
    paintWords(painter, size());
    paintHint(painter);
    paintFrame(painter, hasFocus() ? 3.0 : 1.5);
    if (m_dimmed) painter.fillRect(rect(), oldPictureShadeColour());
}

QImage PlanePane::drawings(double scale, double words) const {
    QImage image((QSizeF(size()) * scale).toSize(), QImage::Format_ARGB32_Premultiplied);
    if (image.isNull()) return image;
    image.setDevicePixelRatio(scale);
    image.fill(Qt::transparent);
    if (!m_scene) return image;
    QPainter painter(&image);
    painter.setFont(font());
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    paintLines(painter, words);
    paintBox(painter, words);
    paintMeasured(painter, false, words);
    painter.save();
    painter.scale(words, words);
    paintWords(painter, QSizeF(size()) / words);
    painter.restore();
    paintFrame(painter, 1.5 * words);
    return image;
}

GreyScale PlanePane::greys() const {
    return m_scene ? GreyScale{m_scene->planes.window, m_scene->planes.level, m_scene->brightness} : GreyScale{};
}

void PlanePane::paintFrame(QPainter& painter, double width) const {
    painter.setPen(QPen(colourOf(m_plane), width));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(QRectF(rect()).adjusted(width / 2, width / 2, -width / 2, -width / 2));
}

/// Draws the lines of the other planes and the reference point.
void PlanePane::paintLines(QPainter& painter, double words) const {
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
            const QLineF line(centre + way * (sign * gapAtReference * words), centre + way * (sign * reach));
            painter.setPen(QPen(QColor(0, 0, 0, 130), 3.0 * words));
            painter.drawLine(line);
            painter.setPen(QPen(colour, 1.25 * words));
            painter.drawLine(line);
        }
    }
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(QColor(0, 0, 0, 160), 3.0 * words));
    painter.drawEllipse(centre, referenceRadius * words, referenceRadius * words);
    painter.setPen(QPen(coloursOverPictures().text, 1.25 * words));
    painter.drawEllipse(centre, referenceRadius * words, referenceRadius * words);
}

/// Draws the box, then the front's line and the grips.
void PlanePane::paintBox(QPainter& painter, double words) const {
    const BoxDrawing& shown = drawing();
    painter.setBrush(Qt::NoBrush);
    const auto paintLine = [&](const QPolygonF& line, const QColor& colour, double width, Qt::PenStyle style) {
        painter.setPen(QPen(QColor(0, 0, 0, 150), (width + 2.0) * words));
        painter.drawPolyline(line);
        painter.setPen(QPen(colour, width * words, style));
        painter.drawPolyline(line);
    };
    const qsizetype count = shown.outline.size();
    for (qsizetype i = 0; i < count; ++i) {
        const QPolygonF edge({shown.outline[i], shown.outline[(i + 1) % count]});
        paintLine(edge, boxColour(), 1.5, Qt::SolidLine);
    }
    if (!shown.frontLine.isEmpty()) paintLine(shown.frontLine, frontColour(), 2.0, Qt::DashLine);
    for (const BoxGrip& grip : shown.grips) {
        painter.save();
        painter.translate(grip.at);
        painter.scale(words, words);
        painter.translate(-grip.at);
        paintGrip(painter, grip);
        painter.restore();
    }
}

void PlanePane::paintMeasured(QPainter& painter, bool withMarking, double words) const {
    std::vector<ShownMeasurement> shown = m_scene->measurements;
    if (withMarking && m_marking) shown.push_back(*m_marking);
    if (!shown.empty())
        paintMeasurements(painter, placedInPlane(shown, mapping().view, m_scene->unitMm), size(), words);
}

/// `pane`: the size of the pane in the painter's units.
void PlanePane::paintWords(QPainter& painter, const QSizeF& pane) const {
    const QColor words = coloursOverPictures().text;
    QFont font = painter.font();
    font.setBold(true);
    font.setPixelSize(18);
    painter.setFont(font);
    paintRimmedText(painter, {10, 23}, letterOf(m_plane), colourOf(m_plane));
    font.setPixelSize(12);
    painter.setFont(font);
    const QFontMetricsF metrics(font);
    paintRimmedText(painter, {10, pane.height() - 10.0}, offsetWords(), words);
    const std::array<QPointF, 4> places{
        QPointF(8, pane.height() / 2.0),
        QPointF(pane.width() - 8 - metrics.horizontalAdvance(m_scene->letters[1]), pane.height() / 2.0),
        QPointF((pane.width() - metrics.horizontalAdvance(m_scene->letters[2])) / 2, 20),
        QPointF((pane.width() - metrics.horizontalAdvance(m_scene->letters[3])) / 2, pane.height() - 10.0)};
    for (std::size_t i = 0; i < places.size(); ++i)
        if (!m_scene->letters[i].isEmpty()) paintRimmedText(painter, places[i], m_scene->letters[i], words);
    if (m_scene->towardsProbe)
        paintProbe(painter, pane, *m_scene->towardsProbe, m_scene->lettersNameProbe ? QString() : tr("probe"));
    // How the plane lies stands below its letter, if that leaves the letters in the middle of the left edge clear.
    constexpr double belowLetter = 41.0;
    if (pane.height() / 2.0 > belowLetter + 20.0) paintRimmedText(painter, {10, belowLetter}, m_scene->lie, words);
}

QString PlanePane::offsetWords() const {
    const double mm = frameOf(m_plane, m_scene->planes, m_scene->beam).forward.dot(m_scene->planes.offsetMm);
    const QString words = m_scene->lengthsKnown ? tr("offset %1 mm") : tr("offset %1 mm (guess)");
    return words.arg(mm, 0, 'f', 1).replace(QLatin1Char('-'), QChar(0x2212));
}

void PlanePane::setTubeCores(const PlaneTubeCores& tubeCores) {
    if (tubeCores == m_tubeCores) return;
    m_tubeCores = tubeCores;
    update();
}

void PlanePane::setHint(const QString& sentence) {
    if (sentence == m_hint) return;
    m_hint = sentence;
    update();
}

/// The hint stands above the lower edge's letters.
void PlanePane::paintHint(QPainter& painter) const {
    if (m_hint.isEmpty()) return;
    QFont font = painter.font();
    font.setBold(false);
    font.setPixelSize(13);
    painter.setFont(font);
    const QFontMetricsF metrics(font);
    const QString shown = metrics.elidedText(m_hint, Qt::ElideRight, width() - 16.0);
    paintRimmedText(painter, {(width() - metrics.horizontalAdvance(shown)) / 2.0, height() - 32.0}, shown,
                    coloursOverPictures().accent);
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
