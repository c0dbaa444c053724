#include "widgets/plots/plot_painting.h"

#include <QFontMetricsF>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "processing/plots/series_style.h"

namespace echolucent {

namespace {

// In pixels, at scale 1.
constexpr double sampleLength = 24.0, sampleGap = 5.0, entryGap = 14.0, axisGap = 4.0, markerRadius = 3.5;

std::vector<double> valuesOf(const Plot& plot, std::vector<double> PlotSeries::*values) {
    std::vector<double> all;
    for (const PlotSeries& series : plot.series)
        all.insert(all.end(), (series.*values).begin(), (series.*values).end());
    return all;
}

QString wordsOf(const std::string& text) { return QString::fromStdString(text); }

std::size_t countOf(const PlotSeries& series) { return std::min(series.x.size(), series.y.size()); }

/// The names of the legend: of the series, then of the bands, each once.
struct LegendEntry {
    QString name;
    std::optional<std::size_t> series;  ///< none: a band
    QPointF at;                         ///< left end of its sample, middle of its row; relative to the legend
};

std::vector<LegendEntry> legendOf(const Plot& plot, double width, const QFontMetricsF& metrics, double scale,
                                  double& height) {
    std::vector<LegendEntry> entries;
    const double row = metrics.height();
    double x = 0.0, y = row / 2;
    const auto add = [&](const std::string& name, std::optional<std::size_t> series) {
        const double wide = scale * (sampleLength + sampleGap) + metrics.horizontalAdvance(wordsOf(name));
        if (x > 0.0 && x + wide > width) {
            x = 0.0;
            y += row;
        }
        entries.push_back({wordsOf(name), series, {x, y}});
        x += wide + scale * entryGap;
    };
    for (std::size_t i = 0; i < plot.series.size(); ++i)
        if (!plot.series[i].name.empty()) add(plot.series[i].name, i);
    std::string named;
    for (const PlotBand& band : plot.bands)
        if (!band.label.empty() && band.label != named) add(named = band.label, std::nullopt);
    height = entries.empty() ? 0.0 : y + row / 2;
    return entries;
}

QPen penOf(const PlotSeries& series, std::size_t colour, bool dark, double scale) {
    const SeriesColour& style = colourAt(colour);
    const std::string_view name = dark ? style.onDark : style.onLight;
    const double width = series.weight == PlotWeight::heavy ? 2.8 : series.weight == PlotWeight::faint ? 0.8 : 1.6;
    QPen pen(QColor(QString::fromLatin1(name.data(), static_cast<qsizetype>(name.size()))), scale * width);
    pen.setCapStyle(Qt::FlatCap);
    pen.setJoinStyle(Qt::RoundJoin);
    QList<qreal> dashes;
    for (const QByteArray& dash :
         QByteArray(style.dashes.data(), static_cast<qsizetype>(style.dashes.size())).split(' '))
        if (!dash.isEmpty()) dashes << dash.toDouble() / width;
    if (!dashes.isEmpty()) pen.setDashPattern(dashes);
    return pen;
}

}  // namespace

PlotPainting::PlotPainting(const Plot& plot, const QRectF& rect, const QPainter& painter, double scale)
    : m_plot(plot),
      m_rect(rect),
      m_scale(scale),
      m_x(valuesOf(plot, &PlotSeries::x), plot.logX, plot.rangeX),
      m_y(valuesOf(plot, &PlotSeries::y), plot.logY, plot.rangeY),
      m_colours(coloursOf(plot.series)) {
    const QFontMetricsF metrics(painter.font());
    m_row = metrics.height();
    double numbers = 0.0, legend = 0.0;
    for (const PlotTick& tick : m_y.ticks())
        numbers = std::max(numbers, metrics.horizontalAdvance(wordsOf(tick.label)));
    (void)legendOf(plot, rect.width(), metrics, scale, legend);
    // Under the title stands what goes up, below the numbers what goes across: no word is turned.
    const double top = (plot.title.empty() ? 0.0 : m_row) + (plot.yLabel.empty() ? 0.0 : m_row) + axisGap;
    const double bottom =
        m_row + (plot.xLabel.empty() ? 0.0 : m_row) + axisGap + (legend > 0.0 ? legend + axisGap : 0.0);
    m_area = rect.adjusted(numbers + axisGap, top, -m_row / 2, -bottom);
    if (m_area.height() < 1.0) m_area.setHeight(1.0);
    if (m_area.width() < 1.0) m_area.setWidth(1.0);
}

double PlotPainting::heightFor(const Plot& plot, double width, double areaHeight, const QFont& font, double scale) {
    const QFontMetricsF metrics(font);
    double legend = 0.0;
    (void)legendOf(plot, width, metrics, scale, legend);
    const int rows = 1 + (plot.title.empty() ? 0 : 1) + (plot.yLabel.empty() ? 0 : 1) + (plot.xLabel.empty() ? 0 : 1);
    return areaHeight + rows * metrics.height() + 2 * axisGap + (legend > 0.0 ? legend + axisGap : 0.0);
}

QPointF PlotPainting::positionOf(double x, double y) const {
    return {m_area.left() + m_x.placeOf(x) * m_area.width(), m_area.bottom() - m_y.placeOf(y) * m_area.height()};
}

std::optional<PlotPainting::Point> PlotPainting::pointAt(QPointF position) const {
    if (!m_area.contains(position)) return std::nullopt;
    std::optional<Point> nearest;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < m_plot.series.size(); ++i) {
        const PlotSeries& series = m_plot.series[i];
        std::optional<std::size_t> own;
        double ownX = std::numeric_limits<double>::infinity();
        for (std::size_t k = 0; k < countOf(series); ++k) {
            if (!m_x.shows(series.x[k]) || !m_y.shows(series.y[k])) continue;
            const double apart = std::abs(positionOf(series.x[k], series.y[k]).x() - position.x());
            if (apart >= ownX) continue;
            ownX = apart;
            own = k;
        }
        if (!own) continue;
        const double apart = std::abs(positionOf(series.x[*own], series.y[*own]).y() - position.y()) + ownX;
        if (apart >= least) continue;
        least = apart;
        nearest = Point{i, *own};
    }
    return nearest;
}

void PlotPainting::paint(QPainter& painter, const PlotPaint& paint) const {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(m_area, paint.ground);
    paintBands(painter, paint);
    paintGrid(painter, paint);
    painter.save();
    painter.setClipRect(m_area.adjusted(-1, -1, 1, 1));
    for (const PlotWeight weight : {PlotWeight::faint, PlotWeight::ordinary, PlotWeight::heavy})
        for (std::size_t i = 0; i < m_plot.series.size(); ++i)
            if (m_plot.series[i].weight == weight) paintSeries(painter, paint, i);
    painter.restore();
    paintMarks(painter, paint);
    paintLegend(painter, paint);
    painter.restore();
}

void PlotPainting::paintBands(QPainter& painter, const PlotPaint& paint) const {
    for (const PlotBand& band : m_plot.bands) {
        if (!m_x.shows(band.from) || !m_x.shows(band.to)) continue;
        const double from = positionOf(band.from, 0).x(), to = positionOf(band.to, 0).x();
        painter.fillRect(QRectF(QPointF(from, m_area.top()), QPointF(to, m_area.bottom())) & m_area, paint.band);
    }
}

void PlotPainting::paintGrid(QPainter& painter, const PlotPaint& paint) const {
    double free = -std::numeric_limits<double>::infinity();
    for (const PlotTick& tick : m_x.ticks()) {
        const double x = m_area.left() + m_x.placeOf(tick.value) * m_area.width();
        painter.setPen(QPen(paint.grid, 1.0));
        painter.drawLine(QPointF(x, m_area.top()), QPointF(x, m_area.bottom()));
        const double wide = painter.fontMetrics().horizontalAdvance(wordsOf(tick.label));
        // In a narrow plot every other number is left out rather than painted over another.
        if (tick.label.empty() || x - wide / 2 < free) continue;
        free = x + wide / 2 + 4.0;
        painter.setPen(paint.text);
        painter.drawText(QRectF(x - wide, m_area.bottom() + axisGap, 2 * wide, m_row), Qt::AlignCenter,
                         wordsOf(tick.label));
    }
    for (const PlotTick& tick : m_y.ticks()) {
        const double y = m_area.bottom() - m_y.placeOf(tick.value) * m_area.height();
        painter.setPen(QPen(paint.grid, 1.0));
        painter.drawLine(QPointF(m_area.left(), y), QPointF(m_area.right(), y));
        if (tick.label.empty()) continue;
        painter.setPen(paint.text);
        painter.drawText(QRectF(m_rect.left(), y - m_row / 2, m_area.left() - axisGap - m_rect.left(), m_row),
                         Qt::AlignRight | Qt::AlignVCenter, wordsOf(tick.label));
    }
    painter.setPen(QPen(paint.frame, 1.0));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(m_area);
    double y = m_rect.top();
    if (!m_plot.title.empty()) {
        QFont bold = painter.font();
        const QFont plain = bold;
        bold.setBold(true);
        painter.setFont(bold);
        painter.setPen(paint.text);
        const QString title =
            painter.fontMetrics().elidedText(wordsOf(m_plot.title), Qt::ElideRight, static_cast<int>(m_rect.width()));
        painter.drawText(QRectF(m_rect.left(), y, m_rect.width(), m_row), Qt::AlignLeft | Qt::AlignVCenter, title);
        painter.setFont(plain);
        y += m_row;
    }
    painter.setPen(paint.secondary);
    painter.drawText(QRectF(m_rect.left(), y, m_rect.width(), m_row), Qt::AlignLeft | Qt::AlignVCenter,
                     wordsOf(m_plot.yLabel));
    painter.drawText(QRectF(m_area.left(), m_area.bottom() + axisGap + m_row, m_area.width(), m_row), Qt::AlignCenter,
                     wordsOf(m_plot.xLabel));
}

void PlotPainting::paintMarks(QPainter& painter, const PlotPaint& paint) const {
    const QFontMetricsF metrics(painter.font());
    const QPen pen(paint.secondary, m_scale, Qt::DashLine);
    // Names of upright lines that stand close together go on lines of text of their own.
    constexpr std::size_t mostRows = 4;
    std::vector<double> ends;
    for (const PlotMark& mark : m_plot.marksX) {
        const double x = m_x.shows(mark.value) ? positionOf(mark.value, 0).x() : m_area.left() - 1;
        if (x < m_area.left() || x > m_area.right()) continue;
        painter.setPen(pen);
        painter.drawLine(QPointF(x, m_area.top()), QPointF(x, m_area.bottom()));
        const double wide = metrics.horizontalAdvance(wordsOf(mark.label));
        const double begin = x + 3 + wide > m_area.right() ? x - 3 - wide : x + 3;
        std::size_t row = 0;
        while (row < ends.size() && begin < ends[row] && row + 1 < mostRows) ++row;
        if (row == ends.size()) ends.push_back(0.0);
        ends[row] = begin + wide + 3;
        painter.setPen(paint.text);
        painter.drawText(QRectF(begin, m_area.top() + 1 + static_cast<double>(row) * m_row, wide + 1, m_row),
                         Qt::AlignLeft | Qt::AlignVCenter, wordsOf(mark.label));
    }
    for (const PlotMark& mark : m_plot.marksY) {
        const double y = m_y.shows(mark.value) ? positionOf(0, mark.value).y() : m_area.top() - 1;
        if (y < m_area.top() || y > m_area.bottom()) continue;
        painter.setPen(pen);
        painter.drawLine(QPointF(m_area.left(), y), QPointF(m_area.right(), y));
        painter.setPen(paint.text);
        const double at = y - m_row < m_area.top() ? y : y - m_row;
        painter.drawText(QRectF(m_area.left(), at, m_area.width() - 3, m_row), Qt::AlignRight | Qt::AlignVCenter,
                         wordsOf(mark.label));
    }
}

void PlotPainting::paintSeries(QPainter& painter, const PlotPaint& paint, std::size_t index) const {
    const PlotSeries& series = m_plot.series[index];
    const QPen pen = penOf(series, m_colours[index], paint.dark, m_scale);
    if (series.line) {
        painter.setPen(pen);
        painter.setBrush(Qt::NoBrush);
        QPainterPath path;
        bool begun = false;
        for (std::size_t k = 0; k < countOf(series); ++k) {
            if (!m_x.shows(series.x[k]) || !m_y.shows(series.y[k])) {
                begun = false;
                continue;
            }
            const QPointF at = positionOf(series.x[k], series.y[k]);
            begun ? path.lineTo(at) : path.moveTo(at);
            begun = true;
        }
        painter.drawPath(path);
    }
    if (!series.markers) return;
    painter.setPen(Qt::NoPen);
    painter.setBrush(pen.color());
    for (std::size_t k = 0; k < countOf(series); ++k) {
        if (!m_x.shows(series.x[k]) || !m_y.shows(series.y[k])) continue;
        const QPointF at = positionOf(series.x[k], series.y[k]);
        painter.drawEllipse(at, m_scale * markerRadius, m_scale * markerRadius);
        if (k >= series.labels.size() || series.labels[k].empty()) continue;
        painter.save();
        painter.setPen(paint.text);
        painter.drawText(at + m_scale * QPointF(5, -4), wordsOf(series.labels[k]));
        painter.restore();
    }
}

void PlotPainting::paintLegend(QPainter& painter, const PlotPaint& paint) const {
    double height = 0.0;
    const auto entries = legendOf(m_plot, m_rect.width(), QFontMetricsF(painter.font()), m_scale, height);
    const QPointF origin(m_rect.left(), m_rect.bottom() - height);
    const double sample = m_scale * sampleLength, radius = m_scale * markerRadius;
    for (const LegendEntry& entry : entries) {
        const QPointF at = origin + entry.at;
        if (!entry.series) {
            painter.fillRect(QRectF(at.x(), at.y() - m_row / 3, sample, m_row * 2 / 3), paint.band);
        } else {
            const PlotSeries& series = m_plot.series[*entry.series];
            const QPen pen = penOf(series, m_colours[*entry.series], paint.dark, m_scale);
            painter.setPen(pen);
            if (series.line) painter.drawLine(at, at + QPointF(sample, 0));
            painter.setPen(Qt::NoPen);
            painter.setBrush(pen.color());
            if (series.markers) painter.drawEllipse(at + QPointF(sample / 2, 0), radius, radius);
        }
        painter.setPen(paint.text);
        painter.drawText(QRectF(at.x() + sample + m_scale * sampleGap, at.y() - m_row / 2, m_rect.width(), m_row),
                         Qt::AlignLeft | Qt::AlignVCenter, entry.name);
    }
}

}  // namespace echolucent
