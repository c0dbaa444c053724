// Number fields of the window. They show and understand numbers by one rule, whatever the language of the desktop.
#pragma once

#include <QDoubleSpinBox>
#include <QSpinBox>
#include <QString>
#include <string>

namespace echolucent {

/// A text that a person typed, for typedNumber(): digits of any script, signs, marks and blanks as ASCII has them, and
/// '?' for every other letter.
[[nodiscard]] std::string plainNumberText(const QString& text);

/// Shows numbers with a decimal point and without groups. Understands them as typedNumber() does, in the digits of any
/// script; what has no or several readings in the field's range is not taken, and the number before it stays. A typed
/// number is rounded to decimals(). A file that is dropped on the field goes to the window.
class NumberBox : public QDoubleSpinBox {
public:
    explicit NumberBox(QWidget* parent = nullptr);
    [[nodiscard]] double valueFromText(const QString& text) const override;
    [[nodiscard]] QValidator::State validate(QString& text, int& position) const override;
    /// Says near the field which readings a doubtful text has.
    void fixup(QString& text) const override;
};

/// The same for whole numbers.
class WholeNumberBox : public QSpinBox {
public:
    explicit WholeNumberBox(QWidget* parent = nullptr);
    [[nodiscard]] int valueFromText(const QString& text) const override;
    [[nodiscard]] QValidator::State validate(QString& text, int& position) const override;
    void fixup(QString& text) const override;
};

}  // namespace echolucent
