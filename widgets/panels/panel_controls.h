// What every control of the panels has in common: a name for scripts, a name for screen readers, a wheel that scrolls.
#pragma once

#include <QString>
#include <QWidget>
#include <string_view>

class QComboBox;
class QLabel;
class QProgressBar;
class QToolButton;

namespace echolucent {

/// The words of a parameter table, which are UTF-8, as a text of Qt.
[[nodiscard]] QString textOf(std::string_view words);

/// Gives a widget its object name, its accessible name and its tool tip; returns the widget.
template <typename Widget>
Widget* named(Widget* widget, const QString& objectName, const QString& accessibleName, const QString& toolTip = {}) {
    widget->setObjectName(objectName);
    widget->setAccessibleName(accessibleName);
    widget->setToolTip(toolTip);
    return widget;
}

/// Lets the wheel change the control only while it has the focus, so that scrolling a dock changes no value by
/// accident.
void wheelNeedsFocus(QWidget* control);

/// A text in front of a control, which is its buddy.
[[nodiscard]] QLabel* labelFor(QWidget* control, const QString& text);

/// A small button with a bent arrow that sets something back; `what` is its accessible name and its tool tip.
[[nodiscard]] QToolButton* resetButton(const QString& objectName, const QString& what);

/// A text that stands back behind the others.
[[nodiscard]] QLabel* secondaryLabel(const QString& text = {});

/// A sentence to be read before something is saved, in as many lines as it needs.
[[nodiscard]] QLabel* noteLabel(const QString& sentence, const QString& objectName);

/// "+3°", "−3°", "0°".
[[nodiscard]] QString angleText(int degrees);

/// Shows how much of a run is done, as a share that is clamped to [0,1]; NaN, a share that nobody knows, changes
/// nothing.
void showShare(QProgressBar* progress, double share);

/// Selects the entry with that data; emits nothing. The data must be there.
void selectData(QComboBox* comboBox, int data);

}  // namespace echolucent
