// Paints a plot with a QPainter: on a canvas of the window, and on paper.
#pragma once

#include <QColor>
#include <QPointF>
#include <QRectF>
#include <cstddef>
#include <optional>

#include "processing/plots/plot.h"
#include "processing/plots/plot_axis.h"

class QPainter;

namespace echolucent {

/// The colours around the lines. The lines themselves have the colours of series_style.h, for the ground of `dark`.
struct PlotPaint {
    QColor ground, text, secondary, grid, frame, band;
    bool dark = false;
};

/// A plot that was laid out into a rectangle: title, axes, lines, and the legend below.
class PlotPainting {
public:
    /// `plot` must outlive this. The font of `painter` decides how high texts are. Lines, marks, and the lengths and
    /// gaps of the legend are `scale` times as large as in letters of the application's size.
    PlotPainting(const Plot& plot, const QRectF& rect, const QPainter& painter, double scale = 1.0);

    void paint(QPainter& painter, const PlotPaint& paint) const;
    /// The part of the rectangle in which the lines stand.
    [[nodiscard]] const QRectF& area() const { return m_area; }
    [[nodiscard]] QPointF positionOf(double x, double y) const;
    /// Where a place stands: the series and its point nearest to a position along the x axis, of the line nearest to
    /// the position. Empty outside the area, and if there is no point.
    struct Point {
        std::size_t series = 0, index = 0;
    };
    [[nodiscard]] std::optional<Point> pointAt(QPointF position) const;
    /// The height that a plot needs, if it is `width` wide and its lines stand in `areaHeight`. `scale` as above.
    [[nodiscard]] static double heightFor(const Plot& plot, double width, double areaHeight, const QFont& font,
                                          double scale = 1.0);

private:
    void paintBands(QPainter& painter, const PlotPaint& paint) const;
    void paintGrid(QPainter& painter, const PlotPaint& paint) const;
    void paintMarks(QPainter& painter, const PlotPaint& paint) const;
    void paintSeries(QPainter& painter, const PlotPaint& paint, std::size_t index) const;
    void paintLegend(QPainter& painter, const PlotPaint& paint) const;

    const Plot& m_plot;
    QRectF m_rect, m_area;
    double m_scale;
    PlotAxis m_x, m_y;
    std::vector<std::size_t> m_colours;
    double m_row = 0.0;  ///< height of a line of text
};

}  // namespace echolucent
