// The OTFs of a motion: over the angle as a map, at a few angles as curves, and the flicker of each mode.
#pragma once

#include <QWidget>
#include <array>

#include "processing/volume/value_scale.h"
#include "widgets/motion/otf_course.h"

class QComboBox;
class QLabel;

namespace echolucent {

class OtfCurvesCanvas;
class OtfMapCanvas;

/// Objects: motion.map, motion.map.curves, motion.map.rows (what the map shows), motion.map.reading, and for each mode
/// motion.map.flicker.static, .eachView, .mean, .movingLeastSquares, .leastFlicker.
class OtfCoursePanel : public QWidget {
    Q_OBJECT

public:
    /// The course outlives the panel.
    explicit OtfCoursePanel(const OtfCourse& course, QWidget* parent = nullptr);

    /// The mode that the motion shows.
    void setMode(MotionOtf mode);
    /// Call this if the course has changed.
    void showCourse();
    /// The file's values, of which the pointed one stands beside its intensity.
    void setValueWindow(const ValueWindow& window);

protected:
    void showEvent(QShowEvent* event) override;

private:
    QWidget* createFlickerTable();
    void showRows();
    void showFlicker();

    struct FlickerRow {
        QLabel* name = nullptr;
        QLabel* value = nullptr;
        QLabel* share = nullptr;
    };

    const OtfCourse& m_course;
    MotionOtf m_mode = MotionOtf::oneOtf;
    OtfMapCanvas* m_map = nullptr;
    OtfCurvesCanvas* m_curves = nullptr;
    QComboBox* m_rows = nullptr;
    QLabel* m_reading = nullptr;
    std::array<FlickerRow, allMotionOtfs.size()> m_flicker;  // in the order of allMotionOtfs
};

}  // namespace echolucent
