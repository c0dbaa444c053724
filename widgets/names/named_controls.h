// Every control, action, panel and pane of a window by its name: for scripts, screen readers and docs/names.md.
#pragma once

#include <QPointer>
#include <QString>
#include <QStringList>
#include <vector>

class QAction;
class QWidget;

namespace echolucent {

/// A control, an action, a panel or a pane.
struct NamedControl {
    QPointer<QObject> object;  ///< a QWidget, or a QAction of a menu; null once it is gone
    QString place;             ///< label of the panel or part of the window that it stands in; "Menus" of an action
    QString name;              ///< object name; empty if it has none, which is a fault
    QString role;              ///< what a screen reader calls it: "slider"
    QString label;             ///< accessible name; of an action its text without marks
    QString description{};     ///< what it does, in one line: its tool tip or that of what it stands in
    QString key{};             ///< of an action: its key as portable text
};

/// Whether a person can do something with a widget: press, choose, type, drag.
[[nodiscard]] bool isControl(const QWidget& widget);

/// All controls, panels, panes, named labels and actions of a window, hidden ones too, in the order in which they were
/// made: widgets, then actions. What Qt makes for itself (scroll bars, the list of a combo box, the field of a number)
/// is left out.
[[nodiscard]] std::vector<NamedControl> namedControls(const QWidget& window);

/// What is wrong with the names of controls, a line each: none, no label for screen readers, or the name of another.
/// Only a widget and an action may share a name.
[[nodiscard]] QStringList problemsOfNames(const std::vector<NamedControl>& controls);

}  // namespace echolucent
