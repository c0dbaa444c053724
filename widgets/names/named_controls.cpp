#include "widgets/names/named_controls.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractScrollArea>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QAccessible>
#include <QAction>
#include <QComboBox>
#include <QDockWidget>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QPlainTextEdit>
#include <QScrollBar>
#include <QTabBar>
#include <QTextDocumentFragment>
#include <QTextEdit>
#include <set>
#include <utility>

#include "widgets/controls/panel_controls.h"

namespace echolucent {

namespace {

QString wordOf(QAccessible::Role role) {
    switch (role) {
        case QAccessible::Button:
        case QAccessible::ButtonMenu: return QStringLiteral("button");
        case QAccessible::Canvas:
        case QAccessible::Chart:
        case QAccessible::Graphic: return QStringLiteral("picture");
        case QAccessible::CheckBox: return QStringLiteral("check box");
        case QAccessible::ComboBox: return QStringLiteral("combo box");
        case QAccessible::EditableText: return QStringLiteral("text field");
        case QAccessible::Grouping: return QStringLiteral("group");
        case QAccessible::List: return QStringLiteral("list");
        case QAccessible::MenuBar: return QStringLiteral("menu bar");
        case QAccessible::PopupMenu: return QStringLiteral("menu");
        case QAccessible::ProgressBar: return QStringLiteral("progress bar");
        case QAccessible::RadioButton: return QStringLiteral("radio button");
        case QAccessible::Slider: return QStringLiteral("slider");
        case QAccessible::SpinBox: return QStringLiteral("number");
        case QAccessible::StaticText: return QStringLiteral("text");
        case QAccessible::Table:
        case QAccessible::Tree: return QStringLiteral("table");
        case QAccessible::ToolBar: return QStringLiteral("tool bar");
        case QAccessible::Window: return QStringLiteral("panel");
        default: return QStringLiteral("part");
    }
}

/// Whether Qt made a widget for its own use.
bool isQtsOwn(const QWidget& widget) {
    if (widget.objectName().startsWith(QLatin1String("qt_")) || qobject_cast<const QScrollBar*>(&widget) ||
        qobject_cast<const QHeaderView*>(&widget) || widget.inherits("QTableCornerButton") ||
        widget.inherits("QDockWidgetTitleButton"))
        return true;
    // Titles of panels stand in the place of the tabs that Qt makes; Qt makes a menu for entries that find no room.
    const QWidget* parent = widget.parentWidget();
    const auto* menu = qobject_cast<const QMenu*>(&widget);
    if (qobject_cast<const QTabBar*>(&widget) && qobject_cast<const QMainWindow*>(parent)) return true;
    if (menu != nullptr && menu->title().isEmpty() && qobject_cast<const QMenuBar*>(parent)) return true;
    for (const QWidget* above = parent; above != nullptr; above = above->parentWidget())
        if (qobject_cast<const QComboBox*>(above) || qobject_cast<const QAbstractSpinBox*>(above)) return true;
    return false;
}

QString oneLine(const QString& words) {
    const QString plain = Qt::mightBeRichText(words) ? QTextDocumentFragment::fromHtml(words).toPlainText() : words;
    return plain.simplified();
}

QString tipOf(const QWidget& widget) {
    for (const QWidget* each = &widget; each != nullptr && !each->isWindow(); each = each->parentWidget())
        if (const QString tip = meaningOf(*each); !tip.isEmpty()) return oneLine(tip);
    return {};
}

/// The panel, the tool bar or the pane in which a widget stands, or the dialog.
QString placeOf(const QWidget& widget) {
    QString named;
    for (const QWidget* above = &widget; above != nullptr; above = above->parentWidget()) {
        if (const auto* dock = qobject_cast<const QDockWidget*>(above)) return dock->windowTitle();
        if (!above->accessibleName().isEmpty() && !isControl(*above)) named = above->accessibleName();
        if (above->isWindow()) break;
    }
    return named.isEmpty() ? QStringLiteral("Window") : named;
}

NamedControl controlOf(QWidget& widget) {
    NamedControl control{&widget, placeOf(widget), widget.objectName(), {}, widget.accessibleName()};
    const QAccessibleInterface* interface = QAccessible::queryAccessibleInterface(&widget);
    if (interface != nullptr) {
        control.role = wordOf(interface->role());
        // Many buttons are called as they are written. What a label says is no name: it changes.
        if (control.label.isEmpty() && !qobject_cast<const QLabel*>(&widget) &&
            !qobject_cast<const QComboBox*>(&widget))
            control.label = oneLine(interface->text(QAccessible::Name)).remove(u'&');
    }
    if (qobject_cast<const QDockWidget*>(&widget)) {
        control.role = QStringLiteral("panel");
        control.label = widget.windowTitle();
    }
    if (const auto* menu = qobject_cast<const QMenu*>(&widget)) {
        control.place = QStringLiteral("Menus");
        if (control.label.isEmpty()) control.label = menu->title().remove(u'&');
    }
    control.description = tipOf(widget);
    if (control.description == control.label) control.description.clear();
    return control;
}

NamedControl controlOf(QAction& action) {
    NamedControl control{
        &action, QStringLiteral("Menus"), action.objectName(),
        action.isCheckable() ? QStringLiteral("menu entry with a check mark") : QStringLiteral("menu entry"),
        action.text().remove(u'&')};
    control.description = oneLine(meaningOf(action));
    // Qt makes a tool tip of the text.
    if (QString(control.label).remove(u'…') == QString(control.description).remove(u'…')) control.description.clear();
    control.key = action.shortcut().toString(QKeySequence::PortableText);
    return control;
}

/// Whether a widget that is no control is worth a name: what has one, unless it is only there to lay others out.
bool isNamedPart(const QWidget& widget) {
    return !widget.objectName().isEmpty() &&
           (!widget.accessibleName().isEmpty() || qobject_cast<const QLabel*>(&widget));
}

}  // namespace

bool isControl(const QWidget& widget) {
    if (isQtsOwn(widget)) return false;
    if (qobject_cast<const QAbstractButton*>(&widget) || qobject_cast<const QAbstractSlider*>(&widget) ||
        qobject_cast<const QAbstractSpinBox*>(&widget) || qobject_cast<const QComboBox*>(&widget) ||
        qobject_cast<const QLineEdit*>(&widget) || qobject_cast<const QTextEdit*>(&widget) ||
        qobject_cast<const QPlainTextEdit*>(&widget) || qobject_cast<const QAbstractItemView*>(&widget))
        return true;
    // Panes and canvases take keys; a scroll area does so for what lies in it.
    return (widget.focusPolicy() & Qt::TabFocus) != 0 && !qobject_cast<const QAbstractScrollArea*>(&widget);
}

std::vector<NamedControl> namedControls(const QWidget& window) {
    std::vector<NamedControl> controls;
    for (QWidget* widget : window.findChildren<QWidget*>()) {
        if (isQtsOwn(*widget)) continue;
        const bool isPanel = qobject_cast<const QDockWidget*>(widget) || qobject_cast<const QMenu*>(widget);
        if (isPanel || isControl(*widget) || isNamedPart(*widget)) controls.push_back(controlOf(*widget));
    }
    for (QAction* action : window.findChildren<QAction*>()) {
        // A menu's own action is called as the menu; a tool bar makes one for each of its widgets.
        const bool isOfAnother =
            action->isSeparator() || action->menu() != nullptr || action->inherits("QWidgetAction");
        if (!isOfAnother) controls.push_back(controlOf(*action));
    }
    return controls;
}

QStringList problemsOfNames(const std::vector<NamedControl>& controls) {
    QStringList problems;
    std::set<std::pair<QString, bool>> known;
    for (const NamedControl& control : controls) {
        const QString what = QStringLiteral("%1 “%2” of %3").arg(control.role, control.label, control.place);
        if (control.name.isEmpty()) {
            problems << what + QStringLiteral(" has no object name");
            continue;
        }
        // A button and the entry of a menu that do the same share a name.
        const bool isAction = qobject_cast<const QAction*>(control.object.data()) != nullptr;
        if (!known.emplace(control.name, isAction).second)
            problems << control.name + QStringLiteral(" is the name of two");
        if (control.label.isEmpty()) problems << QStringLiteral("%1 (%2) has no label").arg(control.name, control.role);
    }
    return problems;
}

}  // namespace echolucent
