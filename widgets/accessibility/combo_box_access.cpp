#include "widgets/accessibility/combo_box_access.h"

#include <QAbstractItemView>
#include <QComboBox>
#include <QLineEdit>
#include <QWidget>

namespace echolucent {

ComboBoxAccess::ComboBoxAccess(QComboBox& box) : QAccessibleWidget(&box, QAccessible::ComboBox), m_box(box) {}

QString ComboBoxAccess::text(QAccessible::Text kind) const {
    if (kind == QAccessible::Value) return m_box.currentText();
    const QString words = QAccessibleWidget::text(kind);
    if (kind != QAccessible::Name) return words;
    // Of a box AT-SPI hands on the name alone, and tells of a change of the value by it.
    if (words.isEmpty() || m_box.currentText().isEmpty()) return words + m_box.currentText();
    return words + QStringLiteral(": ") + m_box.currentText();
}

QAccessible::State ComboBoxAccess::state() const {
    QAccessible::State state = QAccessibleWidget::state();
    state.hasPopup = state.expandable = true;
    state.expanded = m_box.view()->isVisible();
    state.collapsed = !state.expanded;
    state.editable = m_box.isEditable();
    return state;
}

int ComboBoxAccess::childCount() const { return m_box.isEditable() ? 2 : 1; }

QAccessibleInterface* ComboBoxAccess::child(int place) const {
    QWidget* part = nullptr;
    if (place == 0) part = m_box.view();
    if (place == 1) part = m_box.lineEdit();  // null if the box is not editable
    if (part == nullptr) return nullptr;
    // Qt gives them no name: they are called as the box.
    const QString label = QAccessibleWidget::text(QAccessible::Name);
    if (part->accessibleName() != label) part->setAccessibleName(label);
    return QAccessible::queryAccessibleInterface(part);
}

int ComboBoxAccess::indexOfChild(const QAccessibleInterface* child) const {
    if (child->object() == m_box.view()) return 0;
    return m_box.isEditable() && child->object() == m_box.lineEdit() ? 1 : -1;
}

QAccessibleInterface* ComboBoxAccess::childAt(int x, int y) const {
    for (int place = 0; place < childCount(); ++place)
        if (child(place)->rect().contains(x, y) && !child(place)->state().invisible) return child(place);
    return nullptr;
}

QStringList ComboBoxAccess::actionNames() const { return {showMenuAction(), pressAction(), setFocusAction()}; }

void ComboBoxAccess::doAction(const QString& name) {
    if (name != showMenuAction() && name != pressAction()) return QAccessibleWidget::doAction(name);
    if (!m_box.isEnabled()) return;
    if (m_box.view()->isVisible())
        m_box.hidePopup();
    else
        m_box.showPopup();
}

}  // namespace echolucent
