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
    // QAccessibleWidget would call it by the group around it.
    if (kind != QAccessible::Name || !m_button.accessibleName().isEmpty() || m_button.text().isEmpty())
        return QAccessibleWidget::text(kind);
    constexpr char16_t kept = 0x1;
    return m_button.text().replace(QLatin1String("&&"), QString(QChar(kept))).remove(u'&').replace(QChar(kept), u'&');
}

QAccessible::State ButtonAccess::state() const {
    QAccessible::State state = QAccessibleWidget::state();
    state.checkable = m_button.isCheckable();
    state.checked = m_button.isChecked();
    state.pressed = m_button.isDown();
    state.hasPopup = opensMenu(m_button);
    const auto* push = qobject_cast<const QPushButton*>(&m_button);
    state.defaultButton = push != nullptr && push->isDefault();
    return state;
}

QStringList ButtonAccess::actionNames() const {
    if (!m_button.isEnabled()) return {};
    const auto* tool = qobject_cast<const QToolButton*>(&m_button);
    const bool onlyMenu = opensMenu(m_button) && (tool == nullptr || tool->popupMode() == QToolButton::InstantPopup);
    QStringList names;
    if (!onlyMenu) names << (m_button.isCheckable() ? toggleAction() : pressAction());
    if (opensMenu(m_button)) names << showMenuAction();
    return names + QAccessibleWidget::actionNames();
}

void ButtonAccess::doAction(const QString& name) {
    if (name != toggleAction() && name != pressAction() && name != showMenuAction())
        return QAccessibleWidget::doAction(name);
    if (!m_button.isEnabled()) return;
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
