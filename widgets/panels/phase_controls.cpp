#include "widgets/panels/phase_controls.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QSignalBlocker>
#include <QSlider>
#include <QSpinBox>
#include <QStyleOptionSlider>
#include <QToolButton>
#include <algorithm>

#include "widgets/controls/number_box.h"
#include "widgets/controls/panel_controls.h"
#include "widgets/picture_labels/picture_labels.h"

namespace echolucent {

/// Marks below its groove the phases that play.
class PhaseSlider::Groove : public QSlider {
public:
    Groove() : QSlider(Qt::Horizontal) { setMinimumSize(110, 26); }
    void setPlayed(const PhaseRange& range) {
        m_played = range;
        update();
    }

protected:
    void paintEvent(QPaintEvent* event) override {
        QSlider::paintEvent(event);
        QStyleOptionSlider option;
        initStyleOption(&option);
        const int handle = style()->subControlRect(QStyle::CC_Slider, &option, QStyle::SC_SliderHandle, this).width();
        const auto place = [&](int phase) {
            return handle / 2 + QStyle::sliderPositionFromValue(minimum(), maximum(), phase, width() - handle - 1);
        };
        QColor colour = palette().color(QPalette::WindowText);
        colour.setAlphaF(0.6);
        QPainter painter(this);
        const int first = place(m_played.first), last = place(m_played.last);
        painter.fillRect(first, height() - 2, last - first + 1, 1, colour);
        for (const int end : {first, last}) painter.fillRect(end, height() - 5, 1, 4, colour);
    }

private:
    PhaseRange m_played;
};

PhaseSlider::PhaseSlider(QWidget* parent)
    : QWidget(parent),
      m_slider(named(new Groove, "motion.phase", tr("Volume shown"),
                     tr("The volume that is shown (, and . step one back and one on)"))),
      m_readOut(named(new QLabel, "motion.phase.value", tr("Volume shown"))) {
    wheelNeedsFocus(m_slider);
    m_readOut->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(5);
    layout->addWidget(m_slider, 1);
    layout->addWidget(m_readOut);
    setStudy(1, {});
    connect(m_slider, &QSlider::valueChanged, this, [this](int phase) {
        showPhase();
        emit phaseChanged(phase);
    });
}

void PhaseSlider::setStudy(int phases, const PhaseTimes& times) {
    const QSignalBlocker blocker(m_slider);
    m_times = times;
    m_slider->setRange(0, phases - 1);
    m_slider->setPageStep(std::max(1, phases / 10));
    m_slider->setValue(0);
    m_slider->setPlayed({0, phases - 1});
    // Reserve the room now: the controls beside it must not move while the phases play.
    m_readOut->setMinimumWidth(m_readOut->fontMetrics().horizontalAdvance(textOf(phases - 1)) + 4);
    showPhase();
}

void PhaseSlider::setPlayed(const PhaseRange& range) { m_slider->setPlayed(range); }

int PhaseSlider::phase() const { return m_slider->value(); }

void PhaseSlider::setPhase(int phase) {
    const QSignalBlocker blocker(m_slider);
    m_slider->setValue(phase);
    showPhase();
}

QString PhaseSlider::textOf(int phase) const {
    return frameWords({.phase = phase}, MotionScenario::object, m_slider->maximum() + 1, m_times);
}

void PhaseSlider::showPhase() { m_readOut->setText(textOf(phase())); }

PhaseOrder::PhaseOrder(QWidget* parent) : QWidget(parent) {
    const auto number = [](const char* name, const QString& accessibleName, const QString& toolTip) {
        auto* box = named(new WholeNumberBox, name, accessibleName, toolTip);
        box->setAlignment(Qt::AlignRight);
        wheelNeedsFocus(box);
        return box;
    };
    m_first = number("motion.firstPhase", tr("First volume that plays"), tr("The first volume that plays"));
    m_last = number("motion.lastPhase", tr("Last volume that plays"), tr("The last volume that plays"));
    m_all = resetButton("motion.allPhases", tr("Play all volumes"));
    m_pingPong = named(new QCheckBox(tr("Back and forth")), "motion.phasesPingPong", tr("Volumes back and forth"),
                       tr("The volumes play back and forth; otherwise the first follows the last"));
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    layout->addWidget(labelFor(m_first, tr("From")));
    layout->addWidget(m_first);
    layout->addWidget(labelFor(m_last, tr("to")));
    layout->addWidget(m_last);
    layout->addWidget(m_all);
    layout->addSpacing(2);
    layout->addWidget(m_pingPong);
    setPhases(1);
    const auto changed = [this] {
        limitRange();
        tellRange();
    };
    connect(m_first, &QSpinBox::valueChanged, this, changed);
    connect(m_last, &QSpinBox::valueChanged, this, changed);
    connect(m_all, &QToolButton::clicked, this, [this] {
        setRange(std::nullopt);
        tellRange();
    });
    connect(m_pingPong, &QCheckBox::toggled, this, &PhaseOrder::pingPongChanged);
}

void PhaseOrder::setPhases(int phases) {
    m_phases = phases;
    setRange(std::nullopt);
}

void PhaseOrder::setRange(const std::optional<PhaseRange>& range) {
    const PhaseRange played = playedPhases({.phaseRange = range}, m_phases);
    const QSignalBlocker first(m_first), last(m_last);
    m_first->setRange(1, m_phases);
    m_last->setRange(1, m_phases);
    m_first->setValue(played.first + 1);
    m_last->setValue(played.last + 1);
    limitRange();
}

/// Keeps the first phase at or before the last.
void PhaseOrder::limitRange() {
    const QSignalBlocker first(m_first), last(m_last);
    m_first->setRange(1, m_last->value());
    m_last->setRange(m_first->value(), m_phases);
    enableOrSayWhy(*m_all, m_first->value() > 1 || m_last->value() < m_phases, tr("All volumes play already."));
}

void PhaseOrder::tellRange() {
    const PhaseRange range{m_first->value() - 1, m_last->value() - 1};
    emit rangeChanged(range == PhaseRange{0, m_phases - 1} ? std::nullopt : std::optional(range));
}

void PhaseOrder::setPingPong(bool pingPong) {
    const QSignalBlocker blocker(m_pingPong);
    m_pingPong->setChecked(pingPong);
}

}  // namespace echolucent
