#include "widgets/panels/design_plot.h"

#include <QKeyEvent>
#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "widgets/larger_letters.h"
#include "widgets/otf_editor/curve_style.h"
#include "widgets/otf_editor/plot_axes.h"
#include "widgets/otf_editor/plot_colours.h"

namespace echolucent {

namespace {

QString tickText(double value) { return QLocale::c().toString(value, 'g', 3); }

}  // namespace

std::vector<std::size_t> maximaOf(const DesignPlot& plot) {
    std::vector<std::size_t> maxima;
    const std::vector<double>& values = plot.values;
    for (std::size_t first = 1; first + 1 < values.size();) {
        std::size_t last = first;
        while (last + 1 < values.size() && values[last + 1] == values[first]) ++last;
        // A comparison with NaN is false: places beside unknown values are no maxima.
        if (last + 1 < values.size() && values[first] > values[first - 1] && values[last] > values[last + 1])
            maxima.push_back((first + last) / 2);
        first = last + 1;
    }
    return maxima;
}

DesignPlotCanvas::DesignPlotCanvas(QWidget* parent) : QWidget(parent) {
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setMouseTracking(true);
}

void DesignPlotCanvas::setPlot(const DesignPlot& plot) {
    m_plot = plot;
    m_maxima = maximaOf(plot);
    m_chosen.reset();
    m_least = m_largest = 0.0;
    bool any = false;
    for (const double value : plot.values) {
        if (!std::isfinite(value)) continue;
        m_least = any ? std::min(m_least, value) : value;
        m_largest = any ? std::max(m_largest, value) : value;
        any = true;
    }
    m_least = std::min(m_least, 0.0);
    m_largest = std::max(m_largest, 0.0);
    if (!(m_largest > m_least)) m_largest = m_least + 1.0;
    update();
}

void DesignPlotCanvas::setPickable(bool pickable) {
    m_pickable = pickable;
    setFocusPolicy(pickable ? Qt::StrongFocus : Qt::NoFocus);
    setToolTip(pickable ? tr("A click on a maximum makes it the place of the ramp") : QString());
    update();
}

void DesignPlotCanvas::setMarked(std::optional<double> intensity) {
    m_marked = intensity;
    update();
}

QRectF DesignPlotCanvas::area() const {
    const int line = fontMetrics().height();
    const double numbers = std::max(fontMetrics().horizontalAdvance(tickText(m_largest)),
                                    fontMetrics().horizontalAdvance(tickText(m_least)));
    return QRectF(rect()).adjusted(std::max(numbers, 36.0) + 8, 6, -10, -2.0 * line - 6);
}

QPointF DesignPlotCanvas::positionOf(std::size_t index) const {
    const QRectF plot = area();
    return {plot.left() + plot.width() * m_plot.intensities[index],
            plot.bottom() - plot.height() * (m_plot.values[index] - m_least) / (m_largest - m_least)};
}

std::optional<std::size_t> DesignPlotCanvas::maximumAt(QPointF position) const {
    if (!m_pickable) return std::nullopt;
    std::optional<std::size_t> nearest;
    double least = inLettersOf(*this, hitDistance);
    for (std::size_t i = 0; i < m_maxima.size(); ++i) {
        const double distance = std::abs(positionOf(m_maxima[i]).x() - position.x());
        if (distance > least) continue;
        least = distance;
        nearest = i;
    }
    return nearest;
}

void DesignPlotCanvas::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const PlotColours colours = plotColours(themeOf(palette()));
    const QRectF plot = area();
    const int line = fontMetrics().height();
    const double letters = lettersOf(*this);
    painter.fillRect(rect(), colours.background);
    painter.setPen(QPen(colours.frame, 1.0));
    painter.drawRect(plot);
    for (const double tick : {0.0, 0.25, 0.5, 0.75, 1.0}) {
        const double x = plot.left() + plot.width() * tick;
        painter.setPen(QPen(colours.grid, 1.0));
        painter.drawLine(QPointF(x, plot.top()), QPointF(x, plot.bottom()));
        painter.setPen(colours.text);
        const double half = painter.fontMetrics().horizontalAdvance(tickText(tick)) / 2.0 + 1;
        const double centre = std::min(x, width() - half);
        painter.drawText(QRectF(centre - half, plot.bottom() + 2, 2 * half, line), Qt::AlignCenter, tickText(tick));
    }
    painter.setPen(colours.secondary);
    painter.drawText(QRectF(plot.left(), plot.bottom() + 2 + line, plot.width(), line), Qt::AlignCenter,
                     tr("intensity"));
    for (const double tick : tickPositions({m_least, m_largest}, 4)) {
        const double y = plot.bottom() - plot.height() * (tick - m_least) / (m_largest - m_least);
        painter.setPen(QPen(colours.grid, 1.0));
        painter.drawLine(QPointF(plot.left(), y), QPointF(plot.right(), y));
        painter.setPen(colours.text);
        painter.drawText(QRectF(0, std::max(0.0, y - line / 2.0), plot.left() - 5, line),
                         Qt::AlignRight | Qt::AlignVCenter, tickText(tick));
    }
    if (m_marked) {
        const double x = plot.left() + plot.width() * std::clamp(*m_marked, 0.0, 1.0);
        painter.setPen(QPen(colours.text, letters, Qt::DashLine));
        painter.drawLine(QPointF(x, plot.top()), QPointF(x, plot.bottom()));
    }
    const QColor colour = designColor(themeOf(palette()));
    painter.setPen(QPen(colour, 1.6 * letters));
    QPolygonF piece;
    for (std::size_t i = 0; i < m_plot.values.size(); ++i) {
        if (std::isfinite(m_plot.values[i])) {
            piece << positionOf(i);
            continue;
        }
        painter.drawPolyline(piece);  // no line where the values are unknown
        piece.clear();
    }
    painter.drawPolyline(piece);
    if (!m_pickable) return;
    for (std::size_t i = 0; i < m_maxima.size(); ++i) {
        painter.setPen(QPen(i == m_chosen ? colours.text : colour, 1.5));
        painter.setBrush(i == m_chosen ? colour : colours.background);
        painter.drawEllipse(positionOf(m_maxima[i]), 4.0 * letters, 4.0 * letters);
    }
}

void DesignPlotCanvas::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton) return;
    if (const auto hit = maximumAt(event->position())) emit picked(m_plot.intensities[m_maxima[*hit]]);
}

void DesignPlotCanvas::mouseMoveEvent(QMouseEvent* event) {
    m_chosen = maximumAt(event->position());
    setCursor(m_chosen ? Qt::PointingHandCursor : Qt::ArrowCursor);
    update();
}

void DesignPlotCanvas::leaveEvent(QEvent*) {
    m_chosen.reset();
    update();
}

QSize DesignPlotCanvas::sizeHint() const { return inLettersOf(*this, QSize(300, 150)); }

QSize DesignPlotCanvas::minimumSizeHint() const { return inLettersOf(*this, QSize(200, 130)); }

void DesignPlotCanvas::changeEvent(QEvent* event) {
    if (event->type() == QEvent::FontChange) updateGeometry();
    QWidget::changeEvent(event);
}

bool DesignPlotCanvas::event(QEvent* event) {
    // A focused plot keeps its own keys.
    if (event->type() == QEvent::ShortcutOverride) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        if (m_pickable &&
            (key == Qt::Key_Left || key == Qt::Key_Right || key == Qt::Key_Return || key == Qt::Key_Enter))
            event->accept();
    }
    return QWidget::event(event);
}

void DesignPlotCanvas::keyPressEvent(QKeyEvent* event) {
    const int key = event->key();
    const auto last = static_cast<int>(m_maxima.size()) - 1;
    if (!m_pickable || last < 0) return QWidget::keyPressEvent(event);
    if (key == Qt::Key_Left || key == Qt::Key_Right) {
        const int step = key == Qt::Key_Left ? -1 : 1;
        const int from = m_chosen ? static_cast<int>(*m_chosen) + step : step > 0 ? 0 : last;
        m_chosen = static_cast<std::size_t>(std::clamp(from, 0, last));
        update();
    } else if (m_chosen && (key == Qt::Key_Return || key == Qt::Key_Enter)) {
        emit picked(m_plot.intensities[m_maxima[*m_chosen]]);
    } else {
        QWidget::keyPressEvent(event);
    }
}

}  // namespace echolucent
