#include "widgets/otf_editor/parameter_spin_box.h"

#include <QKeyEvent>
#include <QLineEdit>
#include <QSignalBlocker>
#include <QWheelEvent>

namespace echolucent {

namespace {
constexpr int besideNumber = 44;             // pixels: frame, padding and the two arrows
constexpr int wheelBurstMilliseconds = 400;  // a turn of the wheel within this time continues the burst
}  // namespace

ParameterSpinBox::ParameterSpinBox(OtfEditorModel& model, QWidget* parent) : NumberBox(parent), m_model(model) {
    setDecimals(6);
    setSingleStep(0.01);
    setAlignment(Qt::AlignRight);
    setFocusPolicy(Qt::StrongFocus);
    fitWidth();
    m_wheelBurst.setSingleShot(true);
    m_wheelBurst.setInterval(wheelBurstMilliseconds);
    connect(&m_wheelBurst, &QTimer::timeout, this, [this] { m_gesture = OtfEditorModel::noGesture; });
    connect(this, &QDoubleSpinBox::valueChanged, this, [this](double value) {
        m_shown.reset();
        emit edited(value, m_gesture);
    });
}

void ParameterSpinBox::show(double shown, double lowest, double highest) {
    const QSignalBlocker blocker(this);
    if (minimum() != round(lowest) || maximum() != round(highest)) setRange(lowest, highest);
    if (m_shown == shown) return;
    m_shown = shown;
    setValue(shown);
}

double ParameterSpinBox::round(double value) const { return QString::number(value, 'f', decimals()).toDouble(); }

QString ParameterSpinBox::textFromValue(double value) const {
    constexpr int fewestDecimals = 2;
    QString text = QString::number(value, 'f', decimals());
    while (text.endsWith('0') && text.size() - text.indexOf('.') > fewestDecimals + 1) text.chop(1);
    return text;
}

void ParameterSpinBox::fitWidth() { setFixedWidth(fontMetrics().horizontalAdvance("0.000000") + besideNumber); }

void ParameterSpinBox::changeEvent(QEvent* event) {
    NumberBox::changeEvent(event);
    if (event->type() == QEvent::FontChange) fitWidth();
}

void ParameterSpinBox::keyPressEvent(QKeyEvent* event) {
    if (!event->isAutoRepeat()) beginGesture();
    NumberBox::keyPressEvent(event);
}

void ParameterSpinBox::keyReleaseEvent(QKeyEvent* event) {
    QDoubleSpinBox::keyReleaseEvent(event);
    // The base class repeats held keys by a timer, so the gesture lasts until the key is released.
    if (!event->isAutoRepeat()) m_gesture = OtfEditorModel::noGesture;
}

void ParameterSpinBox::focusOutEvent(QFocusEvent* event) {
    QDoubleSpinBox::focusOutEvent(event);
    m_wheelBurst.stop();
    m_gesture = OtfEditorModel::noGesture;
}

void ParameterSpinBox::mousePressEvent(QMouseEvent* event) {
    beginGesture();
    QDoubleSpinBox::mousePressEvent(event);
}

void ParameterSpinBox::mouseReleaseEvent(QMouseEvent* event) {
    QDoubleSpinBox::mouseReleaseEvent(event);
    m_gesture = OtfEditorModel::noGesture;
}

void ParameterSpinBox::wheelEvent(QWheelEvent* event) {
    if (hasFocus()) {
        if (!m_wheelBurst.isActive()) beginGesture();
        m_wheelBurst.start();
        QDoubleSpinBox::wheelEvent(event);
    } else {
        event->ignore();  // a person who scrolls past must not change a curve
    }
}

void ParameterSpinBox::beginGesture() {
    m_wheelBurst.stop();
    m_gesture = m_model.newGesture();
}

}  // namespace echolucent
