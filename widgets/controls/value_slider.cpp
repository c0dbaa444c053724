#include "widgets/controls/value_slider.h"
#include "widgets/controls/number_box.h"

#include <QDoubleSpinBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QSlider>
#include <QToolButton>
#include <cmath>

#include "widgets/controls/panel_controls.h"
#include "widgets/controls/short_spin_box.h"

namespace echolucent {

namespace {

NumberBox* createBox(ValueSlider::Zeros zeros) {
    if (zeros == ValueSlider::Zeros::none) return new ShortSpinBox;
    return new NumberBox;
}

}  // namespace

ValueSlider::ValueSlider(const QString& name, const QString& accessibleName, double step, int decimals, QWidget* parent,
                         Zeros zeros)
    : QWidget(parent),
      m_step(step),
      m_slider(named(new QSlider(Qt::Horizontal), name, accessibleName)),
      m_spinBox(named(createBox(zeros), name + ".value", accessibleName)) {
    if (decimals == 0)
        m_spinBox->takeWholeNumbersOnly();
    else
        m_spinBox->setDecimals(decimals);
    m_spinBox->setSingleStep(step);
    m_spinBox->setAlignment(Qt::AlignRight);
    // Nothing can be set before there is a range. The default ranges of the two differ.
    m_spinBox->setRange(0, 0);
    m_slider->setRange(0, 0);
    m_slider->setMinimumWidth(60);
    wheelNeedsFocus(m_slider);
    wheelNeedsFocus(m_spinBox);
    setFocusProxy(m_slider);

    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_slider, 1);
    layout->addWidget(m_spinBox);

    connect(m_slider, &QSlider::valueChanged, this, &ValueSlider::takeFromSlider);
    connect(m_spinBox, &QDoubleSpinBox::valueChanged, this, &ValueSlider::takeFromSpinBox);
}

bool ValueSlider::event(QEvent* event) {
    // A pointer finds the tool tip through its two controls; a screen reader asks them alone.
    if (event->type() == QEvent::ToolTipChange)
        for (QWidget* control : {static_cast<QWidget*>(m_slider), static_cast<QWidget*>(m_spinBox)})
            control->setAccessibleDescription(toolTip());
    return QWidget::event(event);
}

double ValueSlider::value() const { return m_spinBox->value(); }
double ValueSlider::minimum() const { return m_spinBox->minimum(); }
double ValueSlider::maximum() const { return m_spinBox->maximum(); }

void ValueSlider::setValue(double value) {
    const QSignalBlocker blocker(m_spinBox);
    m_spinBox->setValue(value);
    showOnSlider();
}

void ValueSlider::setRange(double minimum, double maximum) {
    Q_ASSERT(minimum <= maximum);
    if (minimum == this->minimum() && maximum == this->maximum()) return;
    const QSignalBlocker spinBoxBlocker(m_spinBox);
    m_spinBox->setRange(minimum, maximum);
    const QSignalBlocker sliderBlocker(m_slider);
    m_slider->setRange(0, static_cast<int>(std::ceil((this->maximum() - this->minimum()) / m_step - 1e-9)));
    m_slider->setPageStep(std::max(1, m_slider->maximum() / 10));
    showOnSlider();
}

void ValueSlider::setSuffix(const QString& suffix) {
    if (suffix != m_spinBox->suffix()) m_spinBox->setSuffix(suffix);  // else it would be laid out anew
}

void ValueSlider::setStandard(double standard) {
    m_standard = standard;
    if (m_reset == nullptr) {
        m_reset = resetButton(m_slider->objectName() + ".reset", tr("Reset: %1").arg(m_slider->accessibleName()));
        layout()->addWidget(m_reset);
        connect(m_reset, &QToolButton::clicked, m_spinBox, [this] { m_spinBox->setValue(m_standard); });
    }
    showReset();
}

/// The reset compares the numbers as the spin box shows them: rounding is no change.
void ValueSlider::showReset() {
    if (m_reset != nullptr)
        enableOrSayWhy(*m_reset, m_spinBox->textFromValue(m_standard) != m_spinBox->textFromValue(value()),
                       tr("Already at its start value."));
}

void ValueSlider::showOnSlider() {
    const QSignalBlocker blocker(m_slider);
    m_slider->setValue(static_cast<int>(std::lround((value() - minimum()) / m_step)));
    showReset();
}

void ValueSlider::takeFromSlider(int step) {
    {
        const QSignalBlocker blocker(m_spinBox);
        m_spinBox->setValue(minimum() + step * m_step);
    }
    showReset();
    emit valueChanged(value());
}

void ValueSlider::takeFromSpinBox(double value) {
    showOnSlider();
    emit valueChanged(value);
}

}  // namespace echolucent
