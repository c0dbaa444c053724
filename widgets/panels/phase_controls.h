// Which phase of a 4D study is shown, which phases play, and in which order.
#pragma once

#include <QWidget>
#include <optional>

#include "processing/motion/motion_choice.h"

class QCheckBox;
class QLabel;
class QSpinBox;
class QToolButton;

namespace echolucent {

/// The phase shown. Objects: motion.phase, motion.phase.value (read-out: "volume 7 of 20 · 183 ms", without the time if
/// the file does not say it). A line below the slider marks the phases that play. No setter emits a signal.
class PhaseSlider : public QWidget {
    Q_OBJECT

public:
    explicit PhaseSlider(QWidget* parent = nullptr);

    /// Shows the first phase of a study of `phases` phases (>= 1).
    void setStudy(int phases, const PhaseTimes& times);
    void setPlayed(const PhaseRange& range);
    /// Counted from 0.
    [[nodiscard]] int phase() const;
    void setPhase(int phase);

signals:
    void phaseChanged(int phase);

private:
    class Groove;
    [[nodiscard]] QString textOf(int phase) const;
    void showPhase();

    Groove* m_slider = nullptr;
    QLabel* m_readOut = nullptr;
    PhaseTimes m_times;
};

/// Which phases play, and whether back and forth. Objects: motion.firstPhase, motion.lastPhase, motion.allPhases,
/// motion.phasesPingPong. No setter emits a signal.
class PhaseOrder : public QWidget {
    Q_OBJECT

public:
    explicit PhaseOrder(QWidget* parent = nullptr);

    /// The number of the study's phases, at least 1. From then on all of them play, until setRange().
    void setPhases(int phases);
    /// The phases that play; without a value all. Phases that the study does not have are left out.
    void setRange(const std::optional<PhaseRange>& range);
    void setPingPong(bool pingPong);

signals:
    /// No value if all phases of the study play.
    void rangeChanged(const std::optional<echolucent::PhaseRange>& range);
    void pingPongChanged(bool pingPong);

private:
    void limitRange();
    void tellRange();

    QSpinBox* m_first = nullptr;
    QSpinBox* m_last = nullptr;
    QToolButton* m_all = nullptr;
    QCheckBox* m_pingPong = nullptr;
    int m_phases = 1;
};

}  // namespace echolucent
