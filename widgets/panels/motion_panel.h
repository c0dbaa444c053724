// The bar below the picture: the cine of a 4D study, the swivel of the probe, and the OTF of their frames.
#pragma once

#include <QWidget>
#include <array>
#include <cstddef>
#include <optional>

#include "processing/motion/motion_choice.h"

class QButtonGroup;
class QCheckBox;
class QComboBox;
class QFrame;
class QLabel;
class QPushButton;
class QRadioButton;
class QSlider;
class QSpinBox;
class QToolButton;

namespace echolucent {

class FlowLayout;
class PhaseOrder;
class PhaseSlider;

/// The part of a motion that is kept in memory, and need not be made again in the next turn.
struct KeptMotion {
    int frames = 0;  ///< pictures
    int quietPhases = 0;
    int otfs = 0;
    std::size_t frameBytes = 0, quietBytes = 0, otfBytes = 0;
};

/// Objects: motion.play, motion.angle, motion.angle.value (read-out), motion.axis, motion.pingPong, motion.speed,
/// motion.scenario, motion.mode.static, .eachView, .mean, .movingLeastSquares, .leastFlicker, motion.otfPhase,
/// motion.frameRate, motion.otf (opens the choice of the OTF if the bar is narrow), and those of PhaseSlider and
/// PhaseOrder. Controls that play no part in the present motion are hidden. No setter emits a signal.
class MotionPanel : public QWidget {
    Q_OBJECT

public:
    explicit MotionPanel(QWidget* parent = nullptr);

    [[nodiscard]] bool playing() const { return m_playing; }
    void setPlaying(bool playing);
    /// Whole degrees, firstMotionAngle to lastMotionAngle.
    [[nodiscard]] double angle() const;
    void setAngle(double degrees);
    /// Shows the first phase of a study of `phases` phases (>= 1). With one phase only the probe can move: the choice
    /// of what moves is disabled and says why.
    void setStudy(int phases, const PhaseTimes& times);
    /// Counted from 0.
    [[nodiscard]] int phase() const;
    void setPhase(int phase);
    /// The last choice set, with a person's changes since.
    [[nodiscard]] const MotionChoice& choice() const { return m_choice; }
    /// If the study has one phase, only the probe may move.
    void setChoice(const MotionChoice& choice);
    /// Whether the choice of the frames' OTF is seen, and with it how many frames a second there are. [true]
    void setOtfsShown(bool shown);
    /// Shows frames per second; the tool tip says what is kept in memory. Without a rate the read-out is empty.
    void setFrameRate(std::optional<double> framesPerSecond, const KeptMotion& kept = {});

signals:
    /// The person pressed play (true) or pause (false).
    void playRequested(bool play);
    void angleChanged(double degrees);
    /// Counted from 0.
    void phaseChanged(int phase);
    /// `what` names the changed part as a step of the document.
    void choiceChanged(const echolucent::MotionChoice& choice, const QString& what);

protected:
    void showEvent(QShowEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void createControls();
    void createSpeed();
    void createChoices();
    void connectControls();
    void connectChoices();
    void arrange();
    [[nodiscard]] QToolButton* createFold();
    void foldOtfs();
    void showAngle();
    void showAxis();
    void showSpeed();
    void showWhatMoves();
    void take(const MotionChoice& choice, const QString& what);

    MotionChoice m_choice;
    int m_phases = 1;
    PhaseTimes m_times;
    bool m_playing = false;
    QPushButton* m_play = nullptr;
    PhaseSlider* m_phase = nullptr;
    PhaseOrder* m_phaseOrder = nullptr;
    QWidget* m_angleBar = nullptr;
    QSlider* m_angle = nullptr;
    QLabel* m_angleValue = nullptr;
    QComboBox* m_axis = nullptr;
    QCheckBox* m_pingPong = nullptr;
    QComboBox* m_speed = nullptr;
    QComboBox* m_scenario = nullptr;
    std::array<QRadioButton*, allMotionOtfs.size()> m_modes{};  // in the order of allMotionOtfs
    QButtonGroup* m_modeGroup = nullptr;
    FlowLayout *m_firstRow = nullptr, *m_otfRow = nullptr;
    bool m_otfsShown = true;
    QWidget* m_otfs = nullptr;        ///< the row of the OTF; folded, it stands in the popup
    QToolButton* m_folded = nullptr;  ///< opens the popup
    QFrame* m_popup = nullptr;
    QSpinBox* m_otfPhase = nullptr;
    QLabel* m_frameRate = nullptr;
};

}  // namespace echolucent
