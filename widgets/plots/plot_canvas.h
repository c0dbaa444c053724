// A plot in the window, with a read-out under the pointer.
#pragma once

#include <QWidget>

#include "processing/plots/plot.h"

namespace echolucent {

/// Draws a plot as wide as its panel. Its accessible name is the plot's title, its accessible description says the
/// axes and the series. The tool tip under the pointer says the nearest value.
class PlotCanvas : public QWidget {
    Q_OBJECT

public:
    /// `areaHeight` is the height of the part in which the lines stand in letters of the application's size, pixels.
    /// Larger letters make all of the plot larger.
    explicit PlotCanvas(QWidget* parent = nullptr, int areaHeight = 120);

    void setPlot(const Plot& plot);
    [[nodiscard]] const Plot& plot() const { return m_plot; }
    /// The words of the tool tip at a position: "adaptive: 0.42, 0.18", with the axes' labels. Empty beside the lines.
    [[nodiscard]] QString wordsAt(QPointF position) const;

    [[nodiscard]] QSize sizeHint() const override { return {300, heightForWidth(300)}; }
    [[nodiscard]] QSize minimumSizeHint() const override;
    [[nodiscard]] bool hasHeightForWidth() const override { return true; }
    [[nodiscard]] int heightForWidth(int width) const override;

protected:
    bool event(QEvent* event) override;
    void changeEvent(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    [[nodiscard]] QRectF place() const;

    Plot m_plot;
    int m_areaHeight;
};

}  // namespace echolucent
