#include "widgets/panels/panel_controls.h"

#include <QComboBox>
#include <QEvent>
#include <QLabel>
#include <QSignalBlocker>

namespace echolucent {
namespace {

class WheelFilter : public QObject {
public:
    using QObject::QObject;

protected:
    bool eventFilter(QObject* watched, QEvent* event) override {
        if (event->type() != QEvent::Wheel || static_cast<QWidget*>(watched)->hasFocus()) return false;
        event->ignore();  // goes on to the scroll area around the panel
        return true;
    }
};

}  // namespace

void wheelNeedsFocus(QWidget* control) {
    control->setFocusPolicy(Qt::StrongFocus);
    control->installEventFilter(new WheelFilter(control));
}

QLabel* labelFor(QWidget* control, const QString& text) {
    auto* label = new QLabel(text);
    label->setBuddy(control);
    return label;
}

void selectData(QComboBox* comboBox, int data) {
    const QSignalBlocker blocker(comboBox);
    const int index = comboBox->findData(data);
    Q_ASSERT(index >= 0);
    comboBox->setCurrentIndex(index);
}

}  // namespace echolucent
