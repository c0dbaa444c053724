// The plot of the OTF editor: histogram, five curves, and nodes that a person drags.
#pragma once

#include <QWidget>
#include <array>
#include <optional>

#include "processing/comparison/early_light.h"
#include "processing/intensity/histogram.h"
#include "processing/volume/value_scale.h"
#include "widgets/accessibility/spoken_widget.h"
#include "widgets/otf_editor/histogram_backdrop.h"
#include "widgets/otf_editor/otf_editor_model.h"
#include "widgets/otf_editor/plot_axes.h"
#include "widgets/otf_editor/plot_colours.h"

namespace echolucent {

/// Mouse: a drag moves a node (with Shift along one axis), a double click adds one, the middle button pans. The wheel
/// zooms the intensities over the plot or their axis, the opacities over their axis or with Ctrl. A double click on an
/// axis resets that axis, in the corner both. Keys: Tab and the Page keys go from node to node, arrows move the
/// selected one by 1/256 (with Shift by 10/256), Delete removes it, Escape ends a drag without change.
class CurveCanvas : public QWidget, public SpokenWidget {
    Q_OBJECT

public:
    /// A press hits a node if it is nearer than this to the node's centre along each axis, in pixels in
    /// letters of the application's size.
    static constexpr double hitDistance = 10.0;

    explicit CurveCanvas(OtfEditorModel& model, QWidget* parent = nullptr);

    void setHistogram(const IntensityHistogram& histogram);
    void setHistogramScale(HistogramScale scale);
    [[nodiscard]] HistogramScale histogramScale() const { return m_histogramScale; }
    /// Shows at which intensities light is held back early; no value shows none.
    void setEarlyLight(const std::optional<EarlyLight>& light);
    [[nodiscard]] const std::optional<EarlyLight>& earlyLight() const { return m_earlyLight; }
    /// The file's values at intensities 0 and 1, for the second row of numbers. If they are 0 and 1, there is no such
    /// row.
    void setValueWindow(const ValueWindow& window);
    /// Marks the intensity under the cursor in the 3D view. No value removes the mark.
    void setCursorIntensity(std::optional<double> intensity);

    /// The mapping between values and this widget's pixels.
    [[nodiscard]] const PlotAxes& axes() const { return m_axes; }
    void setIntensityRange(const AxisRange& range);
    void setOpacityRange(const AxisRange& range);
    void resetZoom();
    /// Index of the node that a press at `position` would take, -1 for none.
    [[nodiscard]] int nodeAt(QPointF position) const;

    /// The nodes of the manual curve, if it is drawn.
    [[nodiscard]] std::vector<SpokenNode> spokenNodes() const override;
    void chooseSpokenNode(int node) override;
    void setSpokenOpacity(int node, double opacity) override;

    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

signals:
    /// The value under the pointer, and the node there (-1 for none). No value once the pointer has left the plot.
    void hovered(std::optional<echolucent::CurveNode> value, int node);

protected:
    bool event(QEvent* event) override;
    bool focusNextPrevChild(bool next) override;
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    /// Pixels from the middle of a tick to the end of the longest value below it.
    [[nodiscard]] double halfOfValues() const;
    /// Pixels from the name of the row of values to the plot.
    [[nodiscard]] double valueRowGap() const;
    enum class Region { plot, intensityAxis, opacityAxis, corner };
    /// The place at which a person took a node or the plot, so that it does not jump under the pointer.
    struct Grab {
        Qt::MouseButton button;
        int node;  // -1: the plot
        QPointF position;
        CurveNode value;
        AxisRange intensity;
        AxisRange opacity;
    };

    void layOutPlot();
    [[nodiscard]] Region regionAt(QPointF position) const;
    void setAxisRange(AxisRange& range, const AxisRange& wanted);
    void dragTo(QPointF position, Qt::KeyboardModifiers modifiers);
    void panTo(QPointF position);
    void endGrabWithoutChange();
    void hoverAt(QPointF position);
    bool selectNeighbour(int step);
    bool nudgeSelected(const QKeyEvent& event);
    [[nodiscard]] bool handlesKey(const QKeyEvent& event) const;

    void describe();
    void paintAxes(QPainter& painter, const PlotColours& colors) const;
    void paintIntensityAxis(QPainter& painter, const PlotColours& colors) const;
    void paintOpacityAxis(QPainter& painter, const PlotColours& colors) const;
    void paintLightHeldBack(QPainter& painter, const PlotColours& colors) const;
    void paintCurves(QPainter& painter, const PlotColours& colors) const;
    void paintCurve(QPainter& painter, CurveKind kind, const PlotColours& colors) const;
    void paintDesign(QPainter& painter, const PlotColours& colors) const;
    void paintNodes(QPainter& painter, const PlotColours& colors) const;
    void paintGuides(QPainter& painter, const PlotColours& colors) const;
    /// A pen for these letters.
    [[nodiscard]] QPen inLetters(QPen pen) const;
    [[nodiscard]] QPolygonF curvePolygon(CurveKind kind) const;
    [[nodiscard]] QPolygonF polygonOf(const OpacityCurve& curve) const;

    OtfEditorModel& m_model;
    IntensityHistogram m_histogram;
    std::array<double, 256> m_histogramHeights{};
    HistogramScale m_histogramScale = HistogramScale::logarithmic;
    std::optional<EarlyLight> m_earlyLight;
    ValueWindow m_values{0.0, 255.0};
    PlotAxes m_axes;
    std::optional<double> m_cursorIntensity;
    std::optional<QPointF> m_pointer;
    std::optional<Grab> m_grab;
    int m_hoveredNode = -1;
    OtfEditorModel::Gesture m_nudgeGesture = OtfEditorModel::noGesture;
};

}  // namespace echolucent
