#include "widgets/picture_labels/measurement_drawing.h"

#include <QFontMetricsF>
#include <QPainter>
#include <QPolygonF>
#include <algorithm>

#include "widgets/picture_labels/rimmed_text.h"

namespace echolucent {

namespace {

const QColor rimColour(0, 0, 0, 150);

QPointF pixelOf(const PicturePlace& place, const QSizeF& picture) {
    return {picture.width() / 2.0 + place[0] * picture.height(), picture.height() / 2.0 + place[1] * picture.height()};
}

QPolygonF lineThrough(const std::vector<PicturePlace>& places, const QSizeF& picture) {
    QPolygonF line;
    for (const PicturePlace& place : places) line << pixelOf(place, picture);
    return line;
}

void paintLine(QPainter& painter, const QPolygonF& line, double scale) {
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(rimColour, (measurementLineWidth + 2.0) * scale));
    painter.drawPolyline(line);
    painter.setPen(QPen(measurementColour, measurementLineWidth * scale));
    painter.drawPolyline(line);
}

void paintMark(QPainter& painter, const QPointF& at, double scale) {
    const double radius = measurementMarkRadius * scale;
    painter.setPen(QPen(rimColour, scale));
    painter.setBrush(measurementColour);
    painter.drawEllipse(at, radius + scale / 2.0, radius + scale / 2.0);
}

void paintText(QPainter& painter, const PlacedMeasurement& measurement, const QSizeF& picture, double scale) {
    QFont font = painter.font();
    font.setBold(true);
    font.setPixelSize(std::max(1, qRound(measurementFontPixels * scale)));
    painter.setFont(font);
    const QFontMetricsF metrics(font);
    const QString text = QString::fromStdString(measurement.text);
    const double width = metrics.horizontalAdvance(text), gap = measurementTextGap * scale;
    const MeasurementLabel label =
        labelOf(measurement, (width + gap) / picture.height(), picture.width() / picture.height());
    const QPointF at = pixelOf(label.at, picture);
    const double left = label.toTheRight ? at.x() + gap : at.x() - gap - width;
    // A text above or below the picture's edge would be cut.
    const double lowest = picture.height() - metrics.descent(), highest = metrics.ascent();
    const double baseline = at.y() + (metrics.ascent() - metrics.descent()) / 2.0;
    const bool seen = at.y() >= 0.0 && at.y() <= picture.height();
    paintRimmedText(painter, {left, seen ? std::clamp(baseline, highest, std::max(highest, lowest)) : baseline}, text,
                    measurementColour, 1.5 * scale);
}

}  // namespace

void paintMeasurements(QPainter& painter, const std::vector<PlacedMeasurement>& measurements, const QSizeF& picture,
                       double scale) {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    for (const PlacedMeasurement& measurement : measurements) {
        const QPolygonF places = lineThrough(measurement.places, picture);
        paintLine(painter, places, scale);
        if (!measurement.arc.empty()) paintLine(painter, lineThrough(measurement.arc, picture), scale);
        for (const QPointF& at : places) paintMark(painter, at, scale);
    }
    // Words lie over the lines of all.
    for (const PlacedMeasurement& measurement : measurements)
        if (!measurement.text.empty() && !measurement.places.empty()) paintText(painter, measurement, picture, scale);
    painter.restore();
}

}  // namespace echolucent
