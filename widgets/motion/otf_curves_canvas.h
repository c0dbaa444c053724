// The curves of a few angles of a motion in one plot: Petersch 2005, Fig. 10.
#pragma once

#include <QPen>
#include <QWidget>

#include "widgets/motion/otf_course.h"
#include "widgets/otf_editor/plot_axes.h"

namespace echolucent {

/// Object motion.map.curves. Shows the first, the middle and the last row of a course (-45°, 0° and +45° if rows are
/// angles) and the present one. The curve of the mode is heavy, the unsmoothed OTF thin in the same colour and dashes.
class OtfCurvesCanvas : public QWidget {
    Q_OBJECT

public:
    /// The course outlives the canvas.
    explicit OtfCurvesCanvas(const OtfCourse& course, QWidget* parent = nullptr);

    void setMode(MotionOtf mode);
    /// Call this if the course has changed.
    void showCourse();
    /// The rows with curves, in the order of the legend.
    [[nodiscard]] std::vector<int> shownRows() const;

    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    struct Line {
        int row;
        QPen pen;
        QString name;
    };
    [[nodiscard]] std::vector<Line> lines() const;
    [[nodiscard]] QPolygonF polygonOf(const SampledCurve& curve) const;
    void paintOpacityAxis(QPainter& painter) const;
    void paintLegend(QPainter& painter, const std::vector<Line>& lines) const;
    void layOut();

    const OtfCourse& m_course;
    MotionOtf m_mode = MotionOtf::oneOtf;
    PlotAxes m_axes;
};

}  // namespace echolucent
