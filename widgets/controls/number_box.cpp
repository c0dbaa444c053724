#include "widgets/controls/number_box.h"

#include <QAbstractButton>
#include <QKeyEvent>
#include <QLineEdit>
#include <QLocale>
#include <QToolTip>
#include <optional>
#include <string>

#include "processing/parameters/typed_number.h"
#include "widgets/controls/tool_tips.h"

namespace echolucent {

namespace {

/// A letter as typedNumber() knows it: a digit of any script, a sign, a mark or a blank; else '?'.
char plainLetter(QChar letter) {
    constexpr char16_t minus = 0x2212, apostrophe = 0x2019, arabicDecimal = 0x066b, arabicThousands = 0x066c;
    if (const int digit = letter.digitValue(); digit >= 0) return static_cast<char>('0' + digit);
    switch (letter.unicode()) {
        case minus: return '-';
        case arabicDecimal: return ',';
        case apostrophe:
        case arabicThousands: return '\'';
        default: break;
    }
    if (letter.isSpace()) return ' ';
    return QStringLiteral("+-.,'eE").contains(letter) ? letter.toLatin1() : '?';
}

/// What stands between a field's prefix and suffix.
template <typename Box>
std::string typedIn(const Box& box, const QString& text) {
    QString typed = text;
    if (const QString prefix = box.prefix(); typed.startsWith(prefix)) typed.remove(0, prefix.size());
    if (const QString suffix = box.suffix(); typed.endsWith(suffix)) typed.chop(suffix.size());
    return plainNumberText(typed);
}

template <typename Box>
ParameterRange rangeOf(const Box& box) {
    return {static_cast<double>(box.minimum()), static_cast<double>(box.maximum())};
}

template <typename Box>
bool isSpecial(const Box& box, const QString& text) {
    return !box.specialValueText().isEmpty() && text == box.specialValueText();
}

template <typename Box>
QValidator::State stateOf(const Box& box, const QString& text, bool whole) {
    if (isSpecial(box, text)) return QValidator::Acceptable;
    const std::string typed = typedIn(box, text);
    if (typed.find('?') != std::string::npos) return QValidator::Invalid;
    // Never refuse a key: "15" must not be what is left of a "1,5".
    return numberTyped(typed, rangeOf(box), whole) ? QValidator::Acceptable : QValidator::Intermediate;
}

template <typename Box>
QString whyNotTaken(const Box& box, const QString& text, bool whole) {
    const std::string typed = typedIn(box, text);
    if (isDoubtful(typed, rangeOf(box), whole))
        return QString::fromStdString("\"" + typed + "\" has two meanings. " + remedyOfDoubt(typed));
    const ParameterRange range = rangeOf(box);
    const std::string remedy = std::string("Write a ") + (whole ? "whole number" : "number") + " from " +
                               textOf(range.least) + " to " + textOf(range.largest) + ".";
    return QString::fromStdString(typed.empty() ? remedy : "\"" + typed + "\" is not taken. " + remedy);
}

template <typename Box>
void sayWhyNot(const Box& box, const QString& text, bool whole) {
    if (stateOf(box, text, whole) != QValidator::Acceptable)
        QToolTip::showText(box.mapToGlobal(box.rect().bottomLeft()),
                           linesOfToolTip(whyNotTaken(box, text, whole), QToolTip::font()));
}

/// Whether a key is Enter with a text that the field does not take. The key must end there: a dialog would be accepted
/// with the number before.
bool isEnterInVain(const QAbstractSpinBox& box, const QKeyEvent& event) {
    return (event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter) && !box.hasAcceptableInput();
}

void prepare(QAbstractSpinBox& box, QLineEdit& field) {
    box.setLocale(QLocale::c());
    box.setKeyboardTracking(false);  // else "500" would be what is taken of a "5000" that is too large
    field.setAcceptDrops(false);     // else the name of a dropped file would be typed into it
}

}  // namespace

std::string plainNumberText(const QString& text) {
    std::string plain;
    // The marks of the direction of writing that some keyboards put around numbers say nothing.
    for (const QChar letter : text)
        if (letter.category() != QChar::Other_Format) plain += plainLetter(letter);
    return plain;
}

NumberBox::NumberBox(QWidget* parent) : QDoubleSpinBox(parent) { prepare(*this, *lineEdit()); }

double NumberBox::valueFromText(const QString& text) const {
    if (isSpecial(*this, text)) return minimum();
    const std::optional<double> typed = numberTyped(typedIn(*this, text), rangeOf(*this), m_whole);
    return typed ? QString::number(*typed, 'f', decimals()).toDouble() : value();
}

void NumberBox::takeWholeNumbersOnly() {
    m_whole = true;
    setDecimals(0);
}

QValidator::State NumberBox::validate(QString& text, int& /*position*/) const { return stateOf(*this, text, m_whole); }
void NumberBox::fixup(QString& text) const { sayWhyNot(*this, text, m_whole); }

void NumberBox::keyPressEvent(QKeyEvent* event) {
    const bool inVain = isEnterInVain(*this, *event);
    QDoubleSpinBox::keyPressEvent(event);
    if (inVain) event->accept();
}

WholeNumberBox::WholeNumberBox(QWidget* parent) : QSpinBox(parent) { prepare(*this, *lineEdit()); }

int WholeNumberBox::valueFromText(const QString& text) const {
    if (isSpecial(*this, text)) return minimum();
    const std::optional<double> typed = numberTyped(typedIn(*this, text), rangeOf(*this), true);
    return typed ? static_cast<int>(*typed) : value();
}

QValidator::State WholeNumberBox::validate(QString& text, int& /*position*/) const {
    return stateOf(*this, text, true);
}
void WholeNumberBox::fixup(QString& text) const { sayWhyNot(*this, text, true); }

void WholeNumberBox::keyPressEvent(QKeyEvent* event) {
    const bool inVain = isEnterInVain(*this, *event);
    QSpinBox::keyPressEvent(event);
    if (inVain) event->accept();
}

void followTyping(QWidget& dialog, QAbstractButton& button, const std::function<void()>& look) {
    for (QAbstractSpinBox* box : dialog.findChildren<QAbstractSpinBox*>()) {
        QObject::connect(box->findChild<QLineEdit*>(), &QLineEdit::textEdited, &button,
                         [box, &button] { button.setEnabled(box->hasAcceptableInput()); });
        QObject::connect(box, &QAbstractSpinBox::editingFinished, &button, look);
        QObject::connect(&button, &QAbstractButton::pressed, box, &QAbstractSpinBox::interpretText);
    }
}

}  // namespace echolucent
