// The controls of the motion mode.
#pragma once

#include <QWidget>
#include <array>
#include <optional>

#include "processing/motion/motion_mode.h"

class QButtonGroup;
class QCheckBox;
class QComboBox;
class QLabel;
class QPushButton;
class QRadioButton;
class QSlider;

namespace echolucent {

/// Objects: motion.play, motion.angle, motion.angle.value (read-out), motion.axis, motion.scenario, motion.mode.static,
/// .eachView, .mean, .movingLeastSquares, .leastFlicker, motion.pingPong, motion.frameRate. No setter emits a signal.
class MotionPanel : public QWidget {
    Q_OBJECT

public:
    explicit MotionPanel(QWidget* parent = nullptr);

    [[nodiscard]] bool playing() const { return m_playing; }
    void setPlaying(bool playing);
    /// Whole degrees, firstMotionAngle to lastMotionAngle.
    [[nodiscard]] double angle() const;
    void setAngle(double degrees);
    [[nodiscard]] MotionAxis axis() const;
    void setAxis(MotionAxis axis);
    /// With one phase there is nothing but a moving probe, and the choice is disabled and says why.
    void setPhaseCount(int count);
    [[nodiscard]] MotionScenario scenario() const;
    /// Needs more than one phase, the moving probe aside.
    void setScenario(MotionScenario scenario);
    [[nodiscard]] MotionOtf otf() const;
    void setOtf(MotionOtf otf);
    /// Whether the motion goes back and forth; else it starts again from its first frame.
    [[nodiscard]] bool pingPong() const;
    void setPingPong(bool pingPong);
    /// Shows how many frames are shown a second, and how many are kept in memory where there are some; hides the
    /// read-out where that is not given.
    void setFrameRate(std::optional<double> framesPerSecond, int keptFrames = 0);

signals:
    /// The person pressed play (true) or pause (false).
    void playRequested(bool play);
    void angleChanged(double degrees);
    void axisChanged(echolucent::MotionAxis axis);
    void scenarioChanged(echolucent::MotionScenario scenario);
    void otfChanged(echolucent::MotionOtf otf);
    void pingPongChanged(bool pingPong);

protected:
    void changeEvent(QEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    void createControls();
    void createChoices();
    void arrange();
    void showAngle();
    void showPlayIcon();

    bool m_playing = false;
    QPushButton* m_play = nullptr;
    QSlider* m_angle = nullptr;
    QLabel* m_angleValue = nullptr;
    QComboBox* m_axis = nullptr;
    QComboBox* m_scenario = nullptr;
    std::array<QRadioButton*, allMotionOtfs.size()> m_modes{};  // in the order of allMotionOtfs
    QButtonGroup* m_modeGroup = nullptr;
    QCheckBox* m_pingPong = nullptr;
    QLabel* m_frameRate = nullptr;
};

}  // namespace echolucent
