#include "widgets/panels/panel_controls.h"

#include <QAbstractSlider>
#include <QComboBox>
#include <QKeyEvent>
#include <QLabel>
#include <QSignalBlocker>
#include <cstdlib>

namespace echolucent {

QString textOf(std::string_view words) { return QString::fromUtf8(words.data(), static_cast<qsizetype>(words.size())); }

namespace {

class ControlFilter : public QObject {
public:
    using QObject::QObject;

protected:
    bool eventFilter(QObject* watched, QEvent* event) override {
        if (event->type() == QEvent::ShortcutOverride && qobject_cast<QAbstractSlider*>(watched) != nullptr) {
            const int key = static_cast<QKeyEvent*>(event)->key();
            if (key == Qt::Key_Left || key == Qt::Key_Right) event->accept();
            return false;
        }
        if (event->type() != QEvent::Wheel || static_cast<QWidget*>(watched)->hasFocus()) return false;
        event->ignore();  // goes on to the scroll area around the panel
        return true;
    }
};

}  // namespace

void wheelNeedsFocus(QWidget* control) {
    control->setFocusPolicy(Qt::StrongFocus);
    control->installEventFilter(new ControlFilter(control));
}

QLabel* labelFor(QWidget* control, const QString& text) {
    auto* label = new QLabel(text);
    label->setBuddy(control);
    return label;
}

QLabel* secondaryLabel(const QString& text) {
    auto* label = new QLabel(text);
    label->setProperty("secondary", true);
    return label;
}

QString angleText(int degrees) {
    const QString sign = degrees > 0 ? QStringLiteral("+") : degrees < 0 ? QStringLiteral("−") : QString();
    return QStringLiteral("%1%2°").arg(sign).arg(std::abs(degrees));
}

void selectData(QComboBox* comboBox, int data) {
    const QSignalBlocker blocker(comboBox);
    const int index = comboBox->findData(data);
    Q_ASSERT(index >= 0);
    comboBox->setCurrentIndex(index);
}

}  // namespace echolucent
