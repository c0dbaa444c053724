#include "widgets/picture_labels/picture_labels.h"

#include <QFont>
#include <QFontMetricsF>
#include <QLocale>
#include <QObject>
#include <QPainter>
#include <QStringList>
#include <cmath>

#include "processing/picture/annotation_layout.h"
#include "widgets/controls/panel_controls.h"

namespace echolucent {

namespace {

constexpr double annotationRim = 1.0;                // around a shape, in the painter's units at every scale
constexpr QColor annotationRimColour{0, 0, 0, 140};  // as the 3D view's
constexpr QColor shadowColour{0, 0, 0};              // below words, one pixel to the right and down

QColor colourOf(const Colour& colour) { return {colour[0], colour[1], colour[2]}; }

class LabelPainter {
public:
    LabelPainter(QPainter& painter, const QSize& picture, double scale)
        : m_painter(painter), m_picture(picture), m_scale(scale) {
        m_painter.setRenderHint(QPainter::Antialiasing);
        QFont font(QStringLiteral("Arial"));
        font.setStyleHint(QFont::SansSerif);
        font.setBold(true);
        font.setPixelSize(static_cast<int>(std::lround(annotationFontSize * scale)));
        m_painter.setFont(font);
    }

    void paint(const AnnotationLayout& layout) {
        for (const auto& shape : layout.shapes) {
            if (const auto* line = std::get_if<AnnotationLine>(&shape)) paint(*line);
            if (const auto* disc = std::get_if<AnnotationDisc>(&shape)) paint(*disc);
        }
        for (const AnnotationText& text : layout.texts)
            paint(textOf(text.words), placeOf(text.at), text.anchor, colourOf(text.colour));
    }

    /// `at` counts from the upper left corner.
    void paint(const QString& words, const QPointF& at, const TextAnchor& anchor, const QColor& colour) {
        const QFontMetricsF metrics(m_painter.font());
        const QStringList lines = words.split(u'\n');
        const double height =
            metrics.lineSpacing() * static_cast<double>(lines.size() - 1) + metrics.ascent() + metrics.descent();
        double baseline = at.y() - (1.0 - anchor.up) * height + metrics.ascent();
        for (const QString& line : lines) {
            const QPointF start(at.x() - anchor.right * metrics.horizontalAdvance(line), baseline);
            m_painter.setPen(shadowColour);
            m_painter.drawText(start + QPointF(m_scale, m_scale), line);
            m_painter.setPen(colour);
            m_painter.drawText(start, line);
            baseline += metrics.lineSpacing();
        }
    }

private:
    [[nodiscard]] QPointF placeOf(const Point2& at) const { return {at[0], m_picture.height() - at[1]}; }

    void paint(const AnnotationLine& line) {
        const auto stroke = [&](const QColor& colour, double width, Qt::PenCapStyle cap) {
            m_painter.setPen(QPen(colour, width, Qt::SolidLine, cap));
            m_painter.drawLine(placeOf(line.from), placeOf(line.to));
        };
        stroke(annotationRimColour, line.width + 2 * annotationRim, Qt::SquareCap);
        stroke(colourOf(line.colour), line.width, Qt::FlatCap);
    }

    void paint(const AnnotationDisc& disc) {
        m_painter.setPen(Qt::NoPen);
        for (const auto& [colour, radius] : {std::pair(annotationRimColour, disc.radius + annotationRim),
                                             std::pair(colourOf(disc.colour), disc.radius)}) {
            m_painter.setBrush(colour);
            m_painter.drawEllipse(placeOf(disc.centre), radius, radius);
        }
        m_painter.setBrush(Qt::NoBrush);
    }

    QPainter& m_painter;
    QSize m_picture;
    double m_scale;
};

}  // namespace

QString frameWords(const MotionPosition& position, MotionScenario scenario, int phases, const PhaseTimes& times) {
    QStringList words;
    if (movesObject(scenario)) {
        words << QObject::tr("volume %1 of %2").arg(position.phase + 1).arg(phases);
        if (const auto seconds = secondsOfPhase(times, position.phase))
            words << QObject::tr("%1 ms").arg(std::lround(1e3 * *seconds));
    }
    if (movesProbe(scenario)) words << angleText(position.angle);
    return words.join(QStringLiteral(" · "));
}

void paintLabels(QPainter& painter, const QSize& picture, const PictureLabels& labels, double scale) {
    painter.save();
    LabelPainter over(painter, picture, scale);
    const double margin = annotationMargin * scale;
    const QColor colour = colourOf(annotationColour);
    const QFontMetricsF metrics(painter.font());
    const double room = picture.width() - 3.0 * margin - metrics.horizontalAdvance(labels.frame);
    const std::string caption = captionWithin(labels.caption.toStdString(), room, [&metrics](const std::string& line) {
        return metrics.horizontalAdvance(QString::fromStdString(line));
    });
    over.paint(QString::fromStdString(caption), {margin, margin}, {0.0, 1.0}, colour);
    over.paint(labels.frame, {picture.width() - margin, margin}, {1.0, 1.0}, colour);
    over.paint(orientationLayout(scale, labels.camera.frame));
    over.paint(scaleBarLayout(picture.width(), picture.height(), scale, labels.camera.heightMm, labels.spacingKnown));
    painter.restore();
}

}  // namespace echolucent
