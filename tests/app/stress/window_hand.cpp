#include "tests/app/stress/window_hand.h"

#include <QAbstractButton>
#include <QAbstractSlider>
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDialog>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QMenu>
#include <QMouseEvent>
#include <QTest>
#include <QWheelEvent>
#include <array>

namespace echolucent {

namespace {

/// What the hand does not trigger: it ends the program, or takes as long as a hundred other actions.
bool isLeftAlone(const QString& name) { return name == "file.quit" || name == "file.openSimulatedScan"; }

bool asksForMore(const QString& text) { return text.contains(QChar(0x2026)); }

/// As a person types, so that what ends the typing ends it here too.
void type(QAbstractSpinBox& box, const QString& number) {
    box.setFocus();
    box.selectAll();
    QTest::keyClicks(&box, number);
    QTest::keyClick(&box, Qt::Key_Return);
}

QString nameOfWidget(const QObject& object) {
    return object.objectName().isEmpty() ? QString::fromLatin1(object.metaObject()->className()) : object.objectName();
}

}  // namespace

WindowHand::WindowHand(MainWindow& window) : m_window(window) {
    constexpr int soon = 5;  // ms
    m_dismissing.setInterval(soon);
    QObject::connect(&m_dismissing, &QTimer::timeout, &m_dismissing, [this] { dismissDialogs(); });
    m_dismissing.start();
}

void WindowHand::dismissDialogs() {
    if (QWidget* menu = QApplication::activePopupWidget()) menu->close();
    for (QWidget* widget : QApplication::topLevelWidgets())
        if (auto* dialog = qobject_cast<QDialog*>(widget); dialog != nullptr && dialog->isVisible()) dialog->reject();
}

QList<WindowHand::Target> WindowHand::targets() const {
    QList<Target> found;
    for (QWidget* widget : m_window.findChildren<QWidget*>()) {
        const bool takesMouse =
            widget->inherits("echolucent::PlanePane") || widget->inherits("echolucent::ComparePane") ||
            widget->inherits("echolucent::CurveCanvas") || widget->inherits("echolucent::EmphasisCanvas") ||
            widget->inherits("echolucent::DesignPlot");
        if (takesMouse && widget->isVisible() && widget->isEnabled())
            found << Target{widget, widget->size(), [widget](const QPointF& at) { return widget->mapToGlobal(at); }};
    }
    auto* surface = m_window.windowHandle()->findChild<QWindow*>("view3d.surface");
    if (surface != nullptr && m_window.volumeView().isVisible()) {
        const Target picture{surface, surface->size(),
                             [surface](const QPointF& at) { return surface->mapToGlobal(at); }};
        found << picture << picture;  // the hand is there most
    }
    return found;
}

void WindowHand::send(const Target& target, QEvent::Type eventType, const QPointF& place, Qt::MouseButton button,
                      Qt::MouseButtons held, Qt::KeyboardModifiers keys) const {
    if (!target.object) return;
    QMouseEvent event(eventType, place, target.toGlobal(place), button, held, keys);
    QCoreApplication::sendEvent(target.object, &event);
}

QString WindowHand::drag(RandomChoice& choice, const std::function<void()>& meanwhile) {
    const QList<Target> all = targets();
    if (all.isEmpty()) return {};
    const Target target = choice.of(all);
    const auto anyPlace = [&] {
        // Rims and corners have meanings of their own.
        const double rim = choice.chance(0.2) ? 0.02 : 0.2;
        return QPointF(choice.between(rim, 1 - rim) * target.size.width(),
                       choice.between(rim, 1 - rim) * target.size.height());
    };
    const Qt::MouseButton button =
        choice.of(std::array{Qt::LeftButton, Qt::LeftButton, Qt::LeftButton, Qt::MiddleButton, Qt::RightButton});
    const Qt::KeyboardModifiers keys =
        choice.of(std::array{Qt::NoModifier, Qt::NoModifier, Qt::NoModifier, Qt::ShiftModifier, Qt::ControlModifier});
    const QPointF from = anyPlace(), to = anyPlace();
    const int moves = choice.below(8);
    const bool escapes = choice.chance(0.2), takesTime = choice.chance(0.3);
    send(target, QEvent::MouseButtonPress, from, button, button, keys);
    for (int move = 1; move <= moves; ++move) {
        send(target, QEvent::MouseMove, from + (to - from) * (static_cast<double>(move) / moves), Qt::NoButton, button,
             keys);
        if (takesTime) QCoreApplication::processEvents();
        if (meanwhile && move == (moves + 1) / 2) meanwhile();
    }
    if (escapes) QTest::keyClick(&m_window, Qt::Key_Escape);
    send(target, QEvent::MouseButtonRelease, to, button, Qt::NoButton, keys);
    return QStringLiteral("drag over %1 with button %2%3")
        .arg(target.object ? nameOfWidget(*target.object) : QStringLiteral("what is gone"))
        .arg(static_cast<int>(button))
        .arg(escapes ? QStringLiteral(", ended by Escape") : QString());
}

QString WindowHand::turnWheel(RandomChoice& choice) {
    const QList<Target> all = targets();
    if (all.isEmpty()) return {};
    const Target target = choice.of(all);
    const QPointF at(choice.between(0.1, 0.9) * target.size.width(), choice.between(0.1, 0.9) * target.size.height());
    const Qt::KeyboardModifiers keys = choice.of(std::array{Qt::NoModifier, Qt::ControlModifier});
    const int turns = 1 + choice.below(4), way = choice.chance(0.5) ? 120 : -120;
    for (int i = 0; i < turns && target.object; ++i) {
        QWheelEvent turn(at, target.toGlobal(at), {}, {0, way}, Qt::NoButton, keys, Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(target.object, &turn);
    }
    return QStringLiteral("wheel");
}

QString WindowHand::doubleClick(RandomChoice& choice) {
    const QList<Target> all = targets();
    if (all.isEmpty()) return {};
    const Target target = choice.of(all);
    const QPointF at(choice.between(0.1, 0.9) * target.size.width(), choice.between(0.1, 0.9) * target.size.height());
    const QString name = nameOfWidget(*target.object);
    send(target, QEvent::MouseButtonPress, at, Qt::LeftButton, Qt::LeftButton, {});
    send(target, QEvent::MouseButtonRelease, at, Qt::LeftButton, Qt::NoButton, {});
    send(target, QEvent::MouseButtonDblClick, at, Qt::LeftButton, Qt::LeftButton, {});
    send(target, QEvent::MouseButtonRelease, at, Qt::LeftButton, Qt::NoButton, {});
    return "double click on " + name;
}

void WindowHand::press(QWidget* widget, Qt::Key key, Qt::KeyboardModifiers modifiers) const {
    widget->setFocus();
    QTest::keyClick(widget, key, modifiers);
}

QString WindowHand::pressKeys(RandomChoice& choice) {
    QList<QWidget*> takers{&m_window.volumeView()};
    for (const Target& target : targets())
        if (auto* widget = qobject_cast<QWidget*>(target.object)) takers << widget;
    const QPointer<QWidget> taker = choice.of(takers);
    if (!taker->isVisible()) return {};
    constexpr std::array keys{Qt::Key_Left,     Qt::Key_Right,  Qt::Key_Up,     Qt::Key_Down,  Qt::Key_PageUp,
                              Qt::Key_PageDown, Qt::Key_Home,   Qt::Key_Plus,   Qt::Key_Tab,   Qt::Key_Delete,
                              Qt::Key_Minus,    Qt::Key_Return, Qt::Key_Escape, Qt::Key_Space, Qt::Key_S,
                              Qt::Key_M,        Qt::Key_B,      Qt::Key_N};
    const QString name = nameOfWidget(*taker);
    const int count = 1 + choice.below(3);
    const Qt::Key key = choice.of(keys);
    const Qt::KeyboardModifiers modifiers =
        choice.of(std::array{Qt::NoModifier, Qt::NoModifier, Qt::ShiftModifier, Qt::ControlModifier});
    for (int i = 0; i < count && taker && taker->isVisible(); ++i) press(taker, key, modifiers);
    return QStringLiteral("key %1 at %2").arg(QKeySequence(modifiers | key).toString(), name);
}

QString WindowHand::turnControlOf(RandomChoice& choice, const QString& name) {
    auto* dock = m_window.findChild<QDockWidget*>(name);
    dock->show();
    dock->raise();
    return turnControl(choice, *dock);
}

QString WindowHand::turnControl(RandomChoice& choice, const QWidget& within) {
    QList<QWidget*> controls;
    for (QWidget* widget : within.findChildren<QWidget*>()) {
        if (!widget->isVisible() || !widget->isEnabled() || widget->objectName().isEmpty()) continue;
        if (widget->objectName().startsWith(QLatin1String("qt_"))) continue;
        if (auto* button = qobject_cast<QAbstractButton*>(widget)) {
            if (!asksForMore(button->text())) controls << widget;
        } else if (qobject_cast<QComboBox*>(widget) || qobject_cast<QAbstractSlider*>(widget) ||
                   qobject_cast<QAbstractSpinBox*>(widget)) {
            controls << widget;
        }
    }
    if (controls.isEmpty()) return {};
    QWidget* control = choice.of(controls);
    const QString name = control->objectName();
    const Qt::Key way = choice.of(std::array{Qt::Key_Up, Qt::Key_Down, Qt::Key_Up, Qt::Key_Down, Qt::Key_PageUp,
                                             Qt::Key_PageDown, Qt::Key_Home, Qt::Key_End});
    if (auto* button = qobject_cast<QAbstractButton*>(control)) {
        QTest::mouseClick(button, Qt::LeftButton);
        return "click on " + name;
    }
    if (auto* slider = qobject_cast<QAbstractSlider*>(control); slider != nullptr && choice.chance(0.4)) {
        const int wanted =
            slider->minimum() + static_cast<int>(choice.between(0, 1) * (slider->maximum() - slider->minimum()));
        slider->setValue(wanted);
        return QStringLiteral("%1 to %2").arg(name).arg(wanted);
    }
    if (auto* box = qobject_cast<QDoubleSpinBox*>(control); box != nullptr && choice.chance(0.5)) {
        const double wanted = choice.between(box->minimum(), box->maximum());
        type(*box, QString::number(wanted, 'f', box->decimals()));
        return QStringLiteral("%1 typed %2").arg(name).arg(wanted);
    }
    press(control, way);
    return QStringLiteral("%1 at %2").arg(QKeySequence(way).toString(), name);
}

QString WindowHand::raisePanel(RandomChoice& choice) {
    QDockWidget* dock = choice.of(m_window.findChildren<QDockWidget*>());
    if (choice.chance(0.1)) {
        dock->toggleViewAction()->trigger();
    } else {
        dock->show();
        dock->raise();
    }
    return "panel " + dock->objectName();
}

QList<QAction*> WindowHand::actions(bool asking) const {
    QList<QAction*> found;
    for (QAction* action : m_window.findChildren<QAction*>()) {
        if (action->objectName().isEmpty() || !action->isEnabled() || action->menu() != nullptr) continue;
        if (isLeftAlone(action->objectName()) || action->objectName().startsWith(QLatin1String("qt_"))) continue;
        if (asksForMore(action->text()) == asking) found << action;
    }
    return found;
}

QString WindowHand::triggerAction(RandomChoice& choice) {
    QAction* action = choice.of(actions(false));
    const QString name = action->objectName();
    if (name == "view.lightTheme" && !choice.chance(0.1)) return {};  // dressing all widgets anew takes long
    action->trigger();
    return "action " + name;
}

QString WindowHand::askAndDismiss(RandomChoice& choice) {
    QAction* action = choice.of(actions(true));
    const QString name = action->objectName();
    action->trigger();
    return "action " + name + ", dismissed";
}

}  // namespace echolucent
