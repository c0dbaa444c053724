// A slider and a spin box that show one number.
#pragma once

#include <QWidget>

class QSlider;
class QToolButton;

namespace echolucent {

class NumberBox;

/// One number in a range, as slider (coarse steps) and spin box (exact). The slider's object name is `name`, the spin
/// box's `name` + ".value". Both carry the accessible name.
class ValueSlider : public QWidget {
    Q_OBJECT

public:
    /// Which zeros behind the point the spin box shows.
    enum class Zeros { all, none };

    /// The slider moves by `step`. The spin box has `decimals` digits after the point, and takes whole numbers only if
    /// that is 0.
    ValueSlider(const QString& name, const QString& accessibleName, double step, int decimals,
                QWidget* parent = nullptr, Zeros zeros = Zeros::all);

    [[nodiscard]] double value() const;
    [[nodiscard]] double minimum() const;
    [[nodiscard]] double maximum() const;
    /// Clamped into the range; emits nothing.
    void setValue(double value);
    /// Clamps the value into the new range; emits nothing. Needs minimum <= maximum.
    void setRange(double minimum, double maximum);
    void setSuffix(const QString& suffix);
    /// Shows a button, `name` + ".reset", that resets the value to `standard`. It is enabled if the value differs.
    void setStandard(double standard);

signals:
    void valueChanged(double value);

protected:
    bool event(QEvent* event) override;

private:
    void showOnSlider();
    void showReset();
    void takeFromSlider(int step);
    void takeFromSpinBox(double value);

    double m_step;
    QSlider* m_slider;
    NumberBox* m_spinBox;
    QToolButton* m_reset = nullptr;
    double m_standard = 0.0;
};

}  // namespace echolucent
