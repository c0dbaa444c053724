#include "widgets/motion/otf_curves_canvas.h"

#include <QEvent>
#include <QPainter>
#include <algorithm>

#include "widgets/larger_letters.h"
#include "widgets/motion/course_drawing.h"

namespace echolucent {
namespace {

constexpr double shownWidth = 2.0;
constexpr double presentWidth = 3.0;
constexpr double unsmoothedWidth = 1.0;
constexpr double sampleLength = 20.0;  // length of a line in the legend, pixels
constexpr double legendNameGap = 4.0;
constexpr double legendEntryGap = 9.0;

/// Colour and dashes of the fixed rows, as in the paper's Fig. 10: dotted, solid, dashed.
QPen penOf(std::size_t place, Theme theme) {
    static const std::array<Qt::PenStyle, 3> styles{Qt::DotLine, Qt::SolidLine, Qt::DashLine};
    QPen pen(fixedRowColour(place, theme), shownWidth, styles[place]);
    pen.setCapStyle(Qt::FlatCap);
    return pen;
}

}  // namespace

OtfCurvesCanvas::OtfCurvesCanvas(const OtfCourse& course, QWidget* parent) : QWidget(parent), m_course(course) {
    setObjectName("motion.map.curves");
    setAccessibleName(tr("OTFs at chosen angles"));
    setAccessibleDescription(tr("Opacity over intensity at the first, the middle, the last and the present angle."));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    layOut();
}

void OtfCurvesCanvas::setMode(MotionOtf mode) {
    if (mode == m_mode) return;
    m_mode = mode;
    update();
}

void OtfCurvesCanvas::showCourse() { update(); }

void OtfCurvesCanvas::layOut() {
    const QFontMetrics metrics(font());
    const double left = plotLeft(metrics), right = plotRight(metrics);
    const double top = 1.5 * metrics.height() + 4;  // the legend and half a number
    const double bottom = 2.0 * metrics.height() + 6;
    m_axes.rect = QRectF(left, top, std::max(10.0, width() - left - right), std::max(10.0, height() - top - bottom));
}

std::vector<OtfCurvesCanvas::Line> OtfCurvesCanvas::lines() const {
    std::vector<Line> lines;
    const auto exists = [this](int row) {
        return m_course.curve(row, m_mode) != nullptr || m_course.curve(row, MotionOtf::eachView) != nullptr;
    };
    // The legend says the word "volume" only once.
    const auto shortName = [this](int row) {
        return m_course.rows() == OtfCourse::Rows::phases ? QString::number(m_course.numberOf(row))
                                                          : rowName(m_course, row);
    };
    const int last = m_course.rowCount() - 1;
    const std::array<int, 3> fixedRows{0, last / 2, last};
    for (std::size_t i = 0; i < fixedRows.size(); ++i) {
        const bool twice = i > 0 && fixedRows[i] == fixedRows[i - 1];
        if (twice || !exists(fixedRows[i])) continue;
        lines.push_back({fixedRows[i], penOf(i, themeOf(palette())),
                         lines.empty() ? rowName(m_course, fixedRows[i]) : shortName(fixedRows[i])});
    }
    if (const auto present = m_course.presentRow(); present && exists(*present))
        lines.push_back({*present, QPen(coloursOf(palette()).accent, presentWidth, Qt::SolidLine, Qt::FlatCap),
                         tr("now %1").arg(shortName(*present))});
    return lines;
}

std::vector<int> OtfCurvesCanvas::shownRows() const {
    std::vector<int> rows;
    for (const Line& line : lines()) rows.push_back(line.row);
    return rows;
}

QPolygonF OtfCurvesCanvas::polygonOf(const SampledCurve& curve) const {
    QPolygonF polygon;
    const auto count = static_cast<int>(curve.opacities.size());
    for (int i = 0; i < count; ++i)
        polygon << m_axes.positionOf({i / (count - 1.0), curve.opacities[static_cast<std::size_t>(i)]});
    return polygon;
}

void OtfCurvesCanvas::paintEvent(QPaintEvent*) {
    const PlotColours colours = plotColours(themeOf(palette()));
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(rect(), palette().color(QPalette::Window));
    painter.fillRect(m_axes.rect, colours.background);
    paintOpacityAxis(painter);
    paintIntensityAxis(painter, m_axes, colours);
    painter.setPen(QPen(colours.frame, 1.0));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(m_axes.rect.adjusted(-0.5, -0.5, 0.5, 0.5));

    const std::vector<Line> shown = lines();
    const double letters = lettersOf(*this);
    painter.save();
    painter.setClipRect(m_axes.rect.adjusted(-1, -2, 1, 2));
    for (const Line& line : shown) {
        const SampledCurve* unsmoothed = m_course.curve(line.row, MotionOtf::eachView);
        const SampledCurve* curve = m_course.curve(line.row, m_mode);
        if (unsmoothed != nullptr && unsmoothed != curve) {
            QPen thin = line.pen;
            thin.setWidthF(letters * unsmoothedWidth);
            painter.setPen(thin);
            painter.drawPolyline(polygonOf(*unsmoothed));
        }
        if (curve == nullptr) continue;
        QPen heavy = line.pen;
        heavy.setWidthF(letters * heavy.widthF());
        painter.setPen(heavy);
        painter.drawPolyline(polygonOf(*curve));
    }
    painter.restore();
    paintLegend(painter, shown);
}

void OtfCurvesCanvas::paintOpacityAxis(QPainter& painter) const {
    const PlotColours colours = plotColours(themeOf(palette()));
    const double height = painter.fontMetrics().height();
    for (const double tick : {0.0, 0.5, 1.0}) {
        const double y = m_axes.positionOf({0.0, tick}).y();
        painter.setPen(QPen(colours.grid, 1.0));
        painter.drawLine(QPointF(m_axes.rect.left(), y), QPointF(m_axes.rect.right(), y));
        painter.setPen(colours.text);
        painter.drawText(QRectF(0, y - height / 2, m_axes.rect.left() - 6, height), Qt::AlignRight | Qt::AlignVCenter,
                         QString::number(tick));
    }
    painter.save();
    painter.translate(0, m_axes.rect.center().y());
    painter.rotate(-90);
    painter.setPen(colours.secondary);
    painter.drawText(QRectF(-m_axes.rect.height() / 2, 0, m_axes.rect.height(), height), Qt::AlignCenter,
                     tr("opacity"));
    painter.restore();
}

void OtfCurvesCanvas::paintLegend(QPainter& painter, const std::vector<Line>& lines) const {
    const PlotColours colours = plotColours(themeOf(palette()));
    const double height = painter.fontMetrics().height();
    double left = 2.0;
    const auto entry = [&](const QPen& pen, const QString& name) {
        painter.setPen(pen);
        painter.drawLine(QPointF(left, height / 2), QPointF(left + sampleLength, height / 2));
        left += sampleLength + legendNameGap;
        painter.setPen(colours.text);
        painter.drawText(QRectF(left, 0, width(), height), Qt::AlignLeft | Qt::AlignVCenter, name);
        left += painter.fontMetrics().horizontalAdvance(name) + legendEntryGap;
    };
    for (const Line& line : lines) entry(line.pen, line.name);
    const bool smoothed = m_mode != MotionOtf::oneOtf && m_mode != MotionOtf::eachView;
    if (smoothed && !lines.empty()) entry(QPen(colours.secondary, unsmoothedWidth), tr("unsmoothed"));
}

QSize OtfCurvesCanvas::sizeHint() const { return inLettersOf(*this, QSize(380, 200)); }

QSize OtfCurvesCanvas::minimumSizeHint() const { return inLettersOf(*this, QSize(220, 130)); }

void OtfCurvesCanvas::resizeEvent(QResizeEvent*) { layOut(); }

void OtfCurvesCanvas::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() != QEvent::FontChange) return;
    layOut();
    updateGeometry();
}

}  // namespace echolucent
