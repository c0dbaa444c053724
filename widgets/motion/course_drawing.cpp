#include "widgets/motion/course_drawing.h"

#include <QCoreApplication>
#include <cmath>
#include <cstdlib>

namespace echolucent {
namespace {

constexpr double tickLength = 3.0;
constexpr double numberGap = 5.0;  // from the plot to its numbers, pixels

QColor mixed(const QColor& from, const QColor& to, double share) {
    const auto channel = [share](int a, int b) { return static_cast<int>(std::lround(a + share * (b - a))); };
    return {channel(from.red(), to.red()), channel(from.green(), to.green()), channel(from.blue(), to.blue())};
}

}  // namespace

PlotColours plotColours(const QPalette& palette) {
    constexpr int darker = 140;  // per cent
    const QColor panel = palette.color(QPalette::Window);
    const QColor background = panel.lightness() < 128 ? panel.darker(darker) : palette.color(QPalette::Base);
    const QColor text = palette.color(QPalette::WindowText);
    return {background, text, mixed(background, text, 0.66), mixed(background, text, 0.09),
            mixed(background, text, 0.28)};
}

QString rowName(const OtfCourse& course, int row) {
    const int number = course.numberOf(row);
    if (course.rows() == OtfCourse::Rows::phases)
        return QCoreApplication::translate("OtfCourse", "phase %1").arg(number);
    const QString sign = number > 0 ? QStringLiteral("+") : number < 0 ? QStringLiteral("−") : QString();
    return QStringLiteral("%1%2°").arg(sign).arg(std::abs(number));
}

void paintIntensityAxis(QPainter& painter, const PlotAxes& axes, const PlotColours& colours) {
    const QFontMetrics metrics = painter.fontMetrics();
    const double cell = metrics.horizontalAdvance("0.00");
    const int most = std::clamp(static_cast<int>(axes.rect.width() / (1.6 * cell)), 2, 6);
    for (const double tick : tickPositions(axes.intensity, most)) {
        const double x = axes.positionOf({tick, 0.0}).x();
        painter.setPen(QPen(colours.frame, 1.0));
        painter.drawLine(QPointF(x, axes.rect.bottom()), QPointF(x, axes.rect.bottom() + tickLength));
        painter.setPen(colours.text);
        painter.drawText(QRectF(x - cell, axes.rect.bottom() + numberGap, 2 * cell, metrics.height()), Qt::AlignHCenter,
                         QString::number(tick, 'f', 1));
    }
    painter.setPen(colours.secondary);
    painter.drawText(QRectF(axes.rect.left(), axes.rect.bottom() + numberGap + metrics.height(), axes.rect.width(),
                            metrics.height()),
                     Qt::AlignHCenter, QCoreApplication::translate("OtfCourse", "intensity"));
}

}  // namespace echolucent
