#include "widgets/control_keys.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QDialog>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMouseEvent>
#include <QPlainTextEdit>
#include <QRadioButton>
#include <QTabBar>
#include <QTextEdit>

namespace echolucent {

namespace {

bool moves(int key) {
    switch (key) {
        case Qt::Key_Left:
        case Qt::Key_Right:
        case Qt::Key_Up:
        case Qt::Key_Down:
        case Qt::Key_PageUp:
        case Qt::Key_PageDown:
        case Qt::Key_Home:
        case Qt::Key_End: return true;
        default: return false;
    }
}

bool presses(int key) { return key == Qt::Key_Space || key == Qt::Key_Select; }

/// Digits and the other characters that begin a number.
bool beginsNumber(int key) {
    return (key >= Qt::Key_0 && key <= Qt::Key_9) || key == Qt::Key_Period || key == Qt::Key_Comma ||
           key == Qt::Key_Minus;
}

}  // namespace

bool wantsKey(const QWidget& control, const QKeyEvent& event) {
    const int key = event.key();
    if (const auto* view = qobject_cast<const QAbstractItemView*>(&control); view && event.matches(QKeySequence::Copy))
        return true;
    if (event.modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier)) return false;
    if (qobject_cast<const QRadioButton*>(&control)) return moves(key) || presses(key);
    if (qobject_cast<const QAbstractButton*>(&control)) return presses(key);
    if (qobject_cast<const QAbstractSlider*>(&control) || qobject_cast<const QTabBar*>(&control)) return moves(key);
    if (qobject_cast<const QComboBox*>(&control)) return moves(key) || presses(key);
    if (const auto* view = qobject_cast<const QAbstractItemView*>(&control)) {
        const bool edits = key == Qt::Key_F2 && view->editTriggers().testFlag(QAbstractItemView::EditKeyPressed);
        return moves(key) || presses(key) || beginsNumber(key) || key == Qt::Key_Delete || edits;
    }
    return false;
}

ControlKeys::ControlKeys(QObject* parent) : QObject(parent) { QCoreApplication::instance()->installEventFilter(this); }

namespace {

/// A control, and no picture: fields, lists, sliders, buttons.
bool isControl(const QWidget& widget) {
    return qobject_cast<const QLineEdit*>(&widget) || qobject_cast<const QAbstractSpinBox*>(&widget) ||
           qobject_cast<const QAbstractItemView*>(&widget) || qobject_cast<const QAbstractSlider*>(&widget) ||
           qobject_cast<const QAbstractButton*>(&widget) || qobject_cast<const QComboBox*>(&widget) ||
           qobject_cast<const QTextEdit*>(&widget) || qobject_cast<const QPlainTextEdit*>(&widget);
}

}  // namespace

bool ControlKeys::eventFilter(QObject* watched, QEvent* event) {
    const QEvent::Type type = event->type();
    if (type == QEvent::Polish || type == QEvent::MouseButtonPress) {
        auto* button = qobject_cast<QAbstractButton*>(watched);
        if (!button || qobject_cast<QDialog*>(button->window())) return false;
        if (type == QEvent::Polish && button->focusPolicy() != Qt::NoFocus) button->setFocusPolicy(Qt::TabFocus);
        QWidget* focused = QApplication::focusWidget();
        const bool isClicked = type == QEvent::MouseButtonPress && button->isEnabled() &&
                               static_cast<QMouseEvent*>(event)->button() == Qt::LeftButton;
        if (isClicked && focused && focused->window() == button->window() && isControl(*focused)) focused->clearFocus();
        return false;
    }
    if (event->type() != QEvent::ShortcutOverride || watched != QApplication::focusWidget()) return false;
    auto* key = static_cast<QKeyEvent*>(event);
    if (!wantsKey(*static_cast<QWidget*>(watched), *key)) return false;
    key->accept();
    return true;
}

}  // namespace echolucent
