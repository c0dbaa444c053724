// The opacity transfer function over the angle (or phase) as a picture: Petersch 2005, Fig. 11.
#pragma once

#include <QImage>
#include <QWidget>

#include "processing/volume/value_scale.h"
#include "widgets/motion/otf_course.h"
#include "widgets/otf_editor/plot_axes.h"

namespace echolucent {

/// Object motion.map. A row for each angle (or phase), upwards. Intensity goes to the right, and opacity is brightness,
/// with a legend. Rows not shown yet are hatched. The present row is marked at both sides.
class OtfMapCanvas : public QWidget {
    Q_OBJECT

public:
    /// The course outlives the canvas.
    explicit OtfMapCanvas(const OtfCourse& course, QWidget* parent = nullptr);

    /// The mode whose curves are the rows.
    void setMode(MotionOtf mode);
    [[nodiscard]] MotionOtf mode() const { return m_mode; }
    /// The file's values, of which the pointed one stands beside its intensity.
    void setValueWindow(const ValueWindow& window) { m_values = window; }
    /// Call this if the course has changed.
    void showCourse();
    /// The rows as grey levels, 255 = opacity 1, the last row on top. Missing rows are transparent.
    [[nodiscard]] QImage image() const;
    [[nodiscard]] const QRectF& plotRect() const { return m_axes.rect; }

    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

signals:
    /// "+12°, intensity 0.42 (107), opacity 0.18"; empty if the pointer is elsewhere.
    void pointed(const QString& reading);

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;

private:
    [[nodiscard]] QRectF bandOf(int row) const;
    void paintRowAxis(QPainter& painter) const;
    void paintLegend(QPainter& painter) const;
    void layOut();

    const OtfCourse& m_course;
    MotionOtf m_mode = MotionOtf::oneOtf;
    PlotAxes m_axes;
    ValueWindow m_values;
};

}  // namespace echolucent
