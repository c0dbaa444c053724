#include "widgets/otf_editor/histogram_backdrop.h"

#include <QPolygonF>
#include <algorithm>
#include <cmath>

namespace echolucent {

std::array<double, 256> histogramHeights(const IntensityHistogram& histogram, HistogramScale scale) {
    const auto& counts = histogram.counts;
    auto fullest = *std::max_element(counts.begin() + 1, counts.end() - 1);
    if (fullest == 0) fullest = std::max(counts.front(), counts.back());
    std::array<double, 256> heights{};
    if (fullest == 0) return heights;
    const auto reference = static_cast<double>(fullest);
    std::transform(counts.begin(), counts.end(), heights.begin(), [&](std::uint64_t bin) {
        const auto count = static_cast<double>(bin);
        const double height =
            scale == HistogramScale::linear ? count / reference : std::log1p(count) / std::log1p(reference);
        return std::min(height, 1.0);
    });
    return heights;
}

void paintHistogram(QPainter& painter, const PlotAxes& axes, const std::array<double, 256>& heights, const QColor& fill,
                    const QColor& outline) {
    constexpr double headroom = 0.94;  // keeps the fullest bin clear of the frame
    const auto xOf = [&](std::size_t edge) {
        return axes.positionOf({static_cast<double>(edge) / static_cast<double>(heights.size()), 0.0}).x();
    };
    QPolygonF steps;
    for (std::size_t bin = 0; bin < heights.size(); ++bin) {
        const double y = axes.rect.bottom() - headroom * heights[bin] * axes.rect.height();
        steps << QPointF(xOf(bin), y) << QPointF(xOf(bin + 1), y);
    }
    QPolygonF area = steps;
    area << QPointF(xOf(heights.size()), axes.rect.bottom()) << QPointF(xOf(0), axes.rect.bottom());
    painter.setPen(Qt::NoPen);
    painter.setBrush(fill);
    painter.drawPolygon(area);
    painter.setPen(QPen(outline, 1.0));
    painter.setBrush(Qt::NoBrush);
    painter.drawPolyline(steps);
}

}  // namespace echolucent
