#include "widgets/motion/course_drawing.h"

#include <QCoreApplication>
#include <algorithm>
#include <array>

#include "widgets/controls/panel_controls.h"

namespace echolucent {
namespace {

constexpr double tickLength = 3.0;
constexpr double numberGap = 5.0;  // pixels between the plot and its numbers

}  // namespace

QColor fixedRowColour(std::size_t place, Theme theme) {
    static const std::array<ColourOfThemes, 3> colours{{{{0x7f, 0xa7, 0xd9}, {0x2f, 0x66, 0xb5}},
                                                        {{0xc8, 0xcf, 0xd6}, {0x4c, 0x56, 0x61}},
                                                        {{0xd9, 0x8f, 0x7f}, {0xa8, 0x46, 0x2e}}}};
    return colours.at(place).in(theme);
}

QString rowName(const OtfCourse& course, int row) {
    const int number = course.numberOf(row);
    if (course.rows() == OtfCourse::Rows::phases)
        return QCoreApplication::translate("OtfCourse", "volume %1").arg(number);
    return angleText(number);
}

double plotLeft(const QFontMetrics& metrics) { return metrics.horizontalAdvance("+45°") + 2 * markWidth; }

double plotRight(const QFontMetrics& metrics) {
    return legendGap + legendWidth(metrics) + metrics.horizontalAdvance("0.5") + 10;
}

double legendWidth(const QFontMetrics& metrics) { return std::max(12.0, 0.85 * metrics.height()); }

namespace {

std::vector<double> intensityTicks(const QPainter& painter, const PlotAxes& axes) {
    const double cell = painter.fontMetrics().horizontalAdvance("0.00");
    return tickPositions(axes.intensity, std::clamp(static_cast<int>(axes.rect.width() / (1.6 * cell)), 2, 6));
}

}  // namespace

void paintIntensityTicks(QPainter& painter, const PlotAxes& axes, const PlotColours& colours) {
    painter.setPen(QPen(colours.frame, 1.0));
    for (const double tick : intensityTicks(painter, axes)) {
        const double x = axes.positionOf({tick, 0.0}).x();
        painter.drawLine(QPointF(x, axes.rect.bottom()), QPointF(x, axes.rect.bottom() + tickLength));
    }
}

void paintIntensityAxis(QPainter& painter, const PlotAxes& axes, const PlotColours& colours) {
    paintIntensityTicks(painter, axes, colours);
    const QFontMetrics metrics = painter.fontMetrics();
    const double cell = metrics.horizontalAdvance("0.00");
    painter.setPen(colours.text);
    for (const double tick : intensityTicks(painter, axes))
        painter.drawText(
            QRectF(axes.positionOf({tick, 0.0}).x() - cell, axes.rect.bottom() + numberGap, 2 * cell, metrics.height()),
            Qt::AlignHCenter, QString::number(tick, 'f', 1));
    painter.setPen(colours.secondary);
    painter.drawText(QRectF(axes.rect.left(), axes.rect.bottom() + numberGap + metrics.height(), axes.rect.width(),
                            metrics.height()),
                     Qt::AlignHCenter, QCoreApplication::translate("OtfCourse", "intensity"));
}

}  // namespace echolucent
