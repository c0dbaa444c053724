// The plot of a designer: a line over the intensity. A person may pick one of its maxima.
#pragma once

#include <QWidget>
#include <optional>
#include <vector>

#include "processing/designers/design.h"

namespace echolucent {

/// Indices of the local maxima of a plot, ascending. Of equal neighbours the middle one counts. The ends do not count,
/// nor do places beside unknown values.
[[nodiscard]] std::vector<std::size_t> maximaOf(const DesignPlot& plot);

/// Axes with numbers, the line, and a mark at each maximum if maxima can be picked. A click picks the nearest maximum
/// within hitDistance along the intensities. ← and → go from one to the next, Enter picks.
class DesignPlotCanvas : public QWidget {
    Q_OBJECT

public:
    static constexpr double hitDistance = 12.0;  ///< pixels, in letters of the application's size

    explicit DesignPlotCanvas(QWidget* parent = nullptr);

    void setPlot(const DesignPlot& plot);
    void setPickable(bool pickable);
    /// Marks the intensity at which the ramp stands.
    void setMarked(std::optional<double> intensity);
    /// The pixel of a point of the line.
    [[nodiscard]] QPointF positionOf(std::size_t index) const;

    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

signals:
    /// A maximum was picked: its intensity.
    void picked(double intensity);

protected:
    bool event(QEvent* event) override;
    void changeEvent(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    [[nodiscard]] QRectF area() const;
    [[nodiscard]] std::optional<std::size_t> maximumAt(QPointF position) const;

    DesignPlot m_plot;
    std::vector<std::size_t> m_maxima;
    double m_least = 0.0, m_largest = 1.0;  ///< of the values
    bool m_pickable = false;
    std::optional<double> m_marked;
    std::optional<std::size_t> m_chosen;  ///< the chosen maximum, an index into m_maxima; chosen by pointer or key
};

}  // namespace echolucent
