#include "widgets/picture_labels/measurement_drawing.h"

#include <QFontMetricsF>
#include <QPainter>
#include <QPolygonF>
#include <QStringList>
#include <algorithm>

#include "widgets/picture_labels/rimmed_text.h"

namespace echolucent {

namespace {

const QColor measurementRimColour(0, 0, 0, 150);

QPointF pixelOf(const PicturePlace& place, const QSizeF& picture) {
    return {picture.width() / 2.0 + place[0] * picture.height(), picture.height() / 2.0 + place[1] * picture.height()};
}

QPolygonF lineThrough(const std::vector<PicturePlace>& places, const QSizeF& picture) {
    QPolygonF line;
    for (const PicturePlace& place : places) line << pixelOf(place, picture);
    return line;
}

/// A dashed line has a rim without gaps, so that it shows as one line.
void paintLine(QPainter& painter, const QPolygonF& line, double scale, bool dashed) {
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(measurementRimColour, (measurementLineWidth + 2.0) * scale));
    painter.drawPolyline(line);
    QPen pen(measurementColour, measurementLineWidth * scale);
    if (dashed) {
        pen.setCapStyle(Qt::FlatCap);
        pen.setDashPattern({measurementDash / measurementLineWidth, measurementDashGap / measurementLineWidth});
    }
    painter.setPen(pen);
    painter.drawPolyline(line);
}

void paintMark(QPainter& painter, const QPointF& at, double scale) {
    const double radius = measurementMarkRadius * scale;
    painter.setPen(QPen(measurementRimColour, scale));
    painter.setBrush(measurementColour);
    painter.drawEllipse(at, radius + scale / 2.0, radius + scale / 2.0);
}

void paintTexts(QPainter& painter, const std::vector<PlacedMeasurement>& measurements, const QSizeF& picture,
                double scale) {
    QFont font = painter.font();
    font.setBold(true);
    font.setPixelSize(std::max(1, qRound(measurementFontPixels * scale)));
    painter.setFont(font);
    const QFontMetricsF metrics(font);
    const double gap = measurementTextGap * scale;
    QStringList texts;
    std::vector<MeasurementWords> words;
    for (const PlacedMeasurement& measurement : measurements) {
        if (measurement.text.empty() || measurement.places.empty()) continue;
        texts << QString::fromStdString(measurement.text);
        words.push_back({measurement.places, (metrics.horizontalAdvance(texts.back()) + gap) / picture.height(),
                         (metrics.ascent() + metrics.descent()) / picture.height()});
    }
    const std::vector<MeasurementLabel> labels = labelsOf(words, picture.width() / picture.height());
    for (std::size_t i = 0; i < labels.size(); ++i) {
        const QPointF at = pixelOf(labels[i].at, picture);
        const double left = at.x() + (labels[i].toTheRight ? gap : -words[i].width * picture.height());
        paintRimmedText(painter, {left, at.y() + (metrics.ascent() - metrics.descent()) / 2.0},
                        texts[static_cast<qsizetype>(i)], measurementColour, 1.5 * scale);
    }
}

}  // namespace

void paintMeasurements(QPainter& painter, const std::vector<PlacedMeasurement>& measurements, const QSizeF& picture,
                       double scale) {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    for (const PlacedMeasurement& measurement : measurements) {
        const QPolygonF places = lineThrough(measurement.places, picture);
        paintLine(painter, places, scale, measurement.dashed);
        if (!measurement.arc.empty())
            paintLine(painter, lineThrough(measurement.arc, picture), scale, measurement.dashed);
        for (const QPointF& at : places) paintMark(painter, at, scale);
    }
    // Paint texts last, over all lines.
    paintTexts(painter, measurements, picture, scale);
    painter.restore();
}

}  // namespace echolucent
