// A number field that tells held keys and buttons from single steps.
#pragma once

#include <QTimer>
#include <optional>

#include "widgets/controls/number_box.h"
#include "widgets/otf_editor/otf_editor_model.h"

namespace echolucent {

/// Emits `edited` for changes by a person or a script. All steps of one held key or button, or of one burst of the
/// wheel, share a gesture. The field is as wide as its longest number.
class ParameterSpinBox : public NumberBox {
    Q_OBJECT

public:
    explicit ParameterSpinBox(OtfEditorModel& model, QWidget* parent = nullptr);

    /// Shows a value and its range without emitting `edited`. If neither has changed, a number half typed stays.
    void show(double value, double minimum, double maximum);

    [[nodiscard]] QString textFromValue(double value) const override;

signals:
    void edited(double value, echolucent::OtfEditorModel::Gesture gesture);

protected:
    void changeEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void keyReleaseEvent(QKeyEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;

private:
    [[nodiscard]] double round(double value) const;
    void beginGesture();
    void fitWidth();

    OtfEditorModel& m_model;
    std::optional<double> m_shown;  // exact; value() is rounded
    OtfEditorModel::Gesture m_gesture = OtfEditorModel::noGesture;
    QTimer m_wheelBurst;  // runs while a burst of the wheel may go on
};

}  // namespace echolucent
