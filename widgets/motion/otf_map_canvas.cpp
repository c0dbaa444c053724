#include "widgets/motion/otf_map_canvas.h"

#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "processing/adaptive/adaptive_otf_result.h"
#include "widgets/controls/value_text.h"
#include "widgets/larger_letters.h"
#include "widgets/motion/course_drawing.h"

namespace echolucent {
namespace {

constexpr int columns = AdaptiveOtf::sampleCount;
constexpr double rowTickLength = 3.0;
constexpr int degreesBetweenTicks = 15;

int grey(double opacity) { return static_cast<int>(std::lround(255.0 * std::clamp(opacity, 0.0, 1.0))); }

}  // namespace

OtfMapCanvas::OtfMapCanvas(const OtfCourse& course, QWidget* parent) : QWidget(parent), m_course(course) {
    setObjectName("motion.map");
    setAccessibleName(tr("OTF over angle"));
    setAccessibleDescription(
        tr("A row for each angle or volume of the motion, intensity to the right, opacity as brightness."));
    setMouseTracking(true);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    layOut();
}

void OtfMapCanvas::setMode(MotionOtf mode) {
    if (mode == m_mode) return;
    m_mode = mode;
    update();
}

void OtfMapCanvas::showCourse() { update(); }

void OtfMapCanvas::layOut() {
    const QFontMetrics metrics(font());
    const double left = plotLeft(metrics), right = plotRight(metrics);
    const double margin = metrics.height() / 2.0 + 2;
    m_axes.rect = QRectF(left, margin, std::max(10.0, width() - left - right), std::max(10.0, height() - 2 * margin));
}

QImage OtfMapCanvas::image() const {
    const int rows = m_course.rowCount();
    QImage image(columns, rows, QImage::Format_ARGB32);
    image.fill(Qt::transparent);
    for (int row = 0; row < rows; ++row) {
        const SampledCurve* curve = m_course.curve(row, m_mode);
        if (curve == nullptr) continue;
        auto* line = reinterpret_cast<QRgb*>(image.scanLine(rows - 1 - row));
        for (int i = 0; i < columns; ++i) {
            const int level = grey(opacityAt(*curve, i / (columns - 1.0)));
            line[i] = qRgb(level, level, level);
        }
    }
    return image;
}

QRectF OtfMapCanvas::bandOf(int row) const {
    const double height = m_axes.rect.height() / m_course.rowCount();
    return {m_axes.rect.left(), m_axes.rect.bottom() - (row + 1) * height, m_axes.rect.width(), height};
}

void OtfMapCanvas::paintEvent(QPaintEvent*) {
    const PlotColours colours = plotColours(themeOf(palette()));
    QPainter painter(this);
    painter.fillRect(rect(), palette().color(QPalette::Window));
    painter.fillRect(m_axes.rect, QBrush(colours.grid, Qt::BDiagPattern));
    painter.drawImage(m_axes.rect, image());
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(colours.frame, 1.0));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(m_axes.rect.adjusted(-0.5, -0.5, 0.5, 0.5));
    paintIntensityTicks(painter, m_axes, colours);
    paintRowAxis(painter);
    paintLegend(painter);
    if (m_course.presentRow()) return;
    painter.setPen(colours.secondary);
    painter.drawText(m_axes.rect.adjusted(8, 8, -8, -8), Qt::AlignCenter | Qt::TextWordWrap,
                     tr("Play the motion, or move the angle, and the map fills."));
}

void OtfMapCanvas::paintRowAxis(QPainter& painter) const {
    const PlotColours colours = plotColours(themeOf(palette()));
    const double height = painter.fontMetrics().height();
    const int rows = m_course.rowCount();
    const bool angles = m_course.rows() == OtfCourse::Rows::angles;
    const int fitting = std::max(1, static_cast<int>(m_axes.rect.height() / (1.3 * height)));
    const int between =
        angles ? degreesBetweenTicks * (fitting >= 7 ? 1 : 3) : std::max(1, (rows + fitting - 1) / fitting);
    for (int row = 0; row < rows; row += between) {
        const double y = bandOf(row).center().y();
        painter.setPen(QPen(colours.frame, 1.0));
        painter.drawLine(QPointF(m_axes.rect.left() - rowTickLength, y), QPointF(m_axes.rect.left(), y));
        painter.setPen(colours.text);
        painter.drawText(QRectF(0, y - height / 2, m_axes.rect.left() - markWidth - 3, height),
                         Qt::AlignRight | Qt::AlignVCenter,
                         angles ? rowName(m_course, row) : QString::number(m_course.numberOf(row)));
    }
    if (!m_course.presentRow()) return;
    const double y = bandOf(*m_course.presentRow()).center().y();
    painter.setPen(Qt::NoPen);
    painter.setBrush(coloursOf(palette()).accent);
    const double half = markWidth / 2;
    for (const auto& [tip, base] : {std::pair{m_axes.rect.left() - 1, m_axes.rect.left() - markWidth},
                                    std::pair{m_axes.rect.right() + 1, m_axes.rect.right() + markWidth}})
        painter.drawPolygon(QPolygonF{{tip, y}, {base, y - half - 1}, {base, y + half + 1}});
}

void OtfMapCanvas::paintLegend(QPainter& painter) const {
    const PlotColours colours = plotColours(themeOf(palette()));
    const double height = painter.fontMetrics().height();
    const QRectF bar(m_axes.rect.right() + legendGap, m_axes.rect.top(), legendWidth(painter.fontMetrics()),
                     m_axes.rect.height());
    QLinearGradient gradient(bar.bottomLeft(), bar.topLeft());
    gradient.setColorAt(0, Qt::black);
    gradient.setColorAt(1, Qt::white);
    painter.setPen(QPen(colours.frame, 1.0));
    painter.setBrush(gradient);
    painter.drawRect(bar);
    painter.setPen(colours.text);
    for (const double opacity : {0.0, 0.5, 1.0})
        painter.drawText(QRectF(bar.right() + 4, bar.bottom() - opacity * bar.height() - height / 2, width(), height),
                         Qt::AlignLeft | Qt::AlignVCenter, QString::number(opacity));
    // Write along the bar, on its dark half.
    painter.save();
    painter.translate(bar.center().x(), bar.bottom());
    painter.rotate(-90);
    painter.setPen(Qt::white);
    QFont small = painter.font();
    small.setPointSizeF(0.8 * small.pointSizeF());
    painter.setFont(small);
    painter.drawText(QRectF(4, -height / 2, bar.height() / 2, height), Qt::AlignLeft | Qt::AlignVCenter, tr("opacity"));
    painter.restore();
}

QSize OtfMapCanvas::sizeHint() const { return inLettersOf(*this, QSize(380, 260)); }

QSize OtfMapCanvas::minimumSizeHint() const { return inLettersOf(*this, QSize(220, 150)); }

void OtfMapCanvas::resizeEvent(QResizeEvent*) { layOut(); }

void OtfMapCanvas::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() != QEvent::FontChange) return;
    layOut();
    updateGeometry();
}

void OtfMapCanvas::mouseMoveEvent(QMouseEvent* event) {
    QString reading;
    if (m_axes.rect.contains(event->position())) {
        const double share = (m_axes.rect.bottom() - event->position().y()) / m_axes.rect.height();
        const int row = std::min(static_cast<int>(share * m_course.rowCount()), m_course.rowCount() - 1);
        const double intensity = m_axes.valueAt(event->position()).intensity;
        if (const SampledCurve* curve = m_course.curve(row, m_mode))
            reading =
                tr("%1, intensity %2%3, opacity %4")
                    .arg(rowName(m_course, row), QLocale::c().toString(intensity, 'f', 2),
                         valueBeside(intensity, m_values), QLocale::c().toString(opacityAt(*curve, intensity), 'f', 2));
    }
    emit pointed(reading);
}

void OtfMapCanvas::leaveEvent(QEvent*) { emit pointed({}); }

}  // namespace echolucent
