// Number fields of the window. They show and understand numbers by one rule, whatever the language of the desktop.
#pragma once

#include <QDoubleSpinBox>
#include <QSpinBox>
#include <QString>
#include <functional>
#include <string>

class QAbstractButton;

namespace echolucent {

/// A text that a person typed, for typedNumber(): digits of any script, signs, marks and blanks as ASCII has them, and
/// '?' for every other letter.
[[nodiscard]] std::string plainNumberText(const QString& text);

/// Shows numbers with a decimal point and without groups. Understands them as typedNumber() does, in the digits of any
/// script; what has no or several readings in the field's range is not taken, and the number before it stays. A typed
/// number is rounded to decimals(). It is taken on Enter and when the field loses the focus, not key by key. Enter with
/// a text that is not taken ends in the field. A file that is dropped on the field goes to the window.
class NumberBox : public QDoubleSpinBox {
public:
    explicit NumberBox(QWidget* parent = nullptr);
    /// From now on takes whole numbers only, as WholeNumberBox does. For ranges beyond int.
    void takeWholeNumbersOnly();
    [[nodiscard]] double valueFromText(const QString& text) const override;
    [[nodiscard]] QValidator::State validate(QString& text, int& position) const override;
    /// Says near the field why it does not take the text.
    void fixup(QString& text) const override;

protected:
    void keyPressEvent(QKeyEvent* event) override;

private:
    bool m_whole = false;
};

/// The same for whole numbers.
class WholeNumberBox : public QSpinBox {
public:
    explicit WholeNumberBox(QWidget* parent = nullptr);
    [[nodiscard]] int valueFromText(const QString& text) const override;
    [[nodiscard]] QValidator::State validate(QString& text, int& position) const override;
    void fixup(QString& text) const override;

protected:
    void keyPressEvent(QKeyEvent* event) override;
};

/// Lets a dialog's button be pressed right behind a number that is still being typed. While a person types into one of
/// the dialog's number fields, `button` is enabled if the field would take the text. To press it takes the number. Once
/// the number is taken or given up, `look` decides whether the button stays enabled. Call it when all fields are there.
void followTyping(QWidget& dialog, QAbstractButton& button, const std::function<void()>& look);

}  // namespace echolucent
