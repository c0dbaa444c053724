#include "widgets/controls/panel_controls.h"

#include <QAction>
#include <QComboBox>
#include <QEvent>
#include <QLabel>
#include <QProgressBar>
#include <QSignalBlocker>
#include <QTextDocument>
#include <QToolButton>
#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace echolucent {

QString textOf(std::string_view words) { return QString::fromUtf8(words.data(), static_cast<qsizetype>(words.size())); }

namespace {

class WheelFilter : public QObject {
public:
    using QObject::QObject;

protected:
    bool eventFilter(QObject* watched, QEvent* event) override {
        if (event->type() != QEvent::Wheel || static_cast<QWidget*>(watched)->hasFocus()) return false;
        event->ignore();  // the scroll area around the panel gets it
        return true;
    }
};

}  // namespace

void wheelNeedsFocus(QWidget* control) {
    control->setFocusPolicy(Qt::StrongFocus);
    control->installEventFilter(new WheelFilter(control));
}

namespace {

constexpr const char *ifEnabled = "toolTipIfEnabled", *withReason = "toolTipWithReason";

template <typename Control>
QString meaningOfControl(const Control& control) {
    // Another tool tip than the one set here is the control's new meaning.
    const QVariant kept = control.property(ifEnabled);
    const bool isKept = kept.isValid() && control.property(withReason).toString() == control.toolTip();
    return isKept ? kept.toString() : control.toolTip();
}

template <typename Control>
void enableWithReason(Control& control, bool enabled, const QString& whyNot) {
    control.setEnabled(enabled);
    const QString meaning = meaningOfControl(control);
    const QString told = enabled ? meaning : meaning.isEmpty() ? whyNot : meaning + QLatin1Char('\n') + whyNot;
    control.setProperty(ifEnabled, enabled ? QVariant() : QVariant(meaning));
    control.setProperty(withReason, enabled ? QVariant() : QVariant(told));
    if (told != control.toolTip()) control.setToolTip(told);
}

}  // namespace

void enableOrSayWhy(QWidget& control, bool enabled, const QString& whyNot) {
    enableWithReason(control, enabled, whyNot);
}

void enableOrSayWhy(QAction& action, bool enabled, const QString& whyNot) { enableWithReason(action, enabled, whyNot); }

QString meaningOf(const QWidget& control) { return meaningOfControl(control); }

QString meaningOf(const QAction& action) { return meaningOfControl(action); }

QLabel* labelFor(QWidget* control, const QString& text) {
    auto* label = new QLabel(text);
    label->setBuddy(control);
    return label;
}

QString literalToolTip(const QString& text) {
    return Qt::mightBeRichText(text) ? QStringLiteral("<span>%1</span>").arg(text.toHtmlEscaped()) : text;
}

QString literalMenuText(QString text) { return text.replace('&', QLatin1String("&&")); }

QToolButton* resetButton(const QString& objectName, const QString& what) {
    auto* button = named(new QToolButton, objectName, what, what);
    button->setText(QStringLiteral("⟲"));
    button->setAutoRaise(true);
    button->setFocusPolicy(Qt::StrongFocus);
    return button;
}

QLabel* secondaryLabel(const QString& text) {
    auto* label = new QLabel(text);
    label->setProperty("secondary", true);
    return label;
}

QLabel* noteLabel(const QString& sentence, const QString& objectName) {
    auto* label = named(new QLabel(QStringLiteral("⚠ ") + sentence), objectName, QObject::tr("Note: %1").arg(sentence));
    label->setTextFormat(Qt::PlainText);
    label->setWordWrap(true);
    return label;
}

QString angleText(int degrees) {
    const QString sign = degrees > 0 ? QStringLiteral("+") : degrees < 0 ? QStringLiteral("−") : QString();
    return QStringLiteral("%1%2°").arg(sign).arg(std::abs(degrees));
}

void showShare(QProgressBar* progress, double share) {
    if (std::isnan(share)) return;
    constexpr int steps = 1000;
    progress->setRange(0, steps);
    progress->setValue(static_cast<int>(std::lround(std::clamp(share, 0.0, 1.0) * steps)));
}

void selectData(QComboBox* comboBox, int data) {
    const QSignalBlocker blocker(comboBox);
    const int index = comboBox->findData(data);
    Q_ASSERT(index >= 0);
    comboBox->setCurrentIndex(index);
}

}  // namespace echolucent
