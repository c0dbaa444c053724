#include "widgets/accessibility/button_access.h"

#include <QAbstractButton>
#include <QAction>
#include <QActionGroup>
#include <QButtonGroup>
#include <QKeySequence>
#include <QPushButton>
#include <QToolButton>

namespace echolucent {

namespace {

bool opensMenu(const QAbstractButton& button) {
    if (const auto* tool = qobject_cast<const QToolButton*>(&button)) return tool->menu() != nullptr;
    const auto* push = qobject_cast<const QPushButton*>(&button);
    return push != nullptr && push->menu() != nullptr;
}

/// Whether one of several buttons, this one among them, is always checked.
bool isOneOfSeveral(const QAbstractButton& button) {
    if (button.group() != nullptr) return button.group()->exclusive();
    const auto* tool = qobject_cast<const QToolButton*>(&button);
    const QAction* action = tool != nullptr ? tool->defaultAction() : nullptr;
    if (action != nullptr && action->actionGroup() != nullptr) return action->actionGroup()->isExclusive();
    return button.autoExclusive();
}

}  // namespace

ButtonAccess::ButtonAccess(QAbstractButton& button)
    : QAccessibleWidget(&button, QAccessible::Button), m_button(button) {}

// A button may be asked for before it has all its properties.
QAccessible::Role ButtonAccess::role() const {
    if (opensMenu(m_button)) return QAccessible::ButtonMenu;
    if (!m_button.isCheckable()) return QAccessible::Button;
    return isOneOfSeveral(m_button) ? QAccessible::RadioButton : QAccessible::CheckBox;
}

QString ButtonAccess::text(QAccessible::Text kind) const {
    const QString words = QAccessibleWidget::text(kind);
    return kind == QAccessible::Name && words.isEmpty() ? m_button.text().remove(u'&') : words;
}

QAccessible::State ButtonAccess::state() const {
    QAccessible::State state = QAccessibleWidget::state();
    state.checkable = m_button.isCheckable();
    state.checked = m_button.isChecked();
    state.pressed = m_button.isDown();
    state.hasPopup = opensMenu(m_button);
    return state;
}

QStringList ButtonAccess::actionNames() const {
    if (!m_button.isEnabled()) return {};
    const QString click = opensMenu(m_button)      ? showMenuAction()
                          : m_button.isCheckable() ? toggleAction()
                                                   : pressAction();
    return {click, setFocusAction()};
}

void ButtonAccess::doAction(const QString& name) {
    if (name != toggleAction() && name != pressAction() && name != showMenuAction())
        return QAccessibleWidget::doAction(name);
    auto* tool = qobject_cast<QToolButton*>(&m_button);
    if (name == showMenuAction() && tool != nullptr)
        QMetaObject::invokeMethod(tool, &QToolButton::showMenu, Qt::QueuedConnection);
    else
        QMetaObject::invokeMethod(&m_button, &QAbstractButton::click, Qt::QueuedConnection);
}

QStringList ButtonAccess::keyBindingsForAction(const QString& name) const {
    if (name == setFocusAction() || m_button.shortcut().isEmpty()) return QAccessibleWidget::keyBindingsForAction(name);
    return {m_button.shortcut().toString(QKeySequence::NativeText)};
}

}  // namespace echolucent
