// What all controls of the panels share: a name for scripts, a name for screen readers, a wheel that scrolls.
#pragma once

#include <QString>
#include <QWidget>
#include <string_view>

class QAction;
class QComboBox;
class QLabel;
class QProgressBar;
class QToolButton;

namespace echolucent {

/// The UTF-8 words of a parameter table as Qt text.
[[nodiscard]] QString textOf(std::string_view words);

/// Gives a widget its object name, its accessible name and its tool tip; returns the widget.
template <typename Widget>
Widget* named(Widget* widget, const QString& objectName, const QString& accessibleName, const QString& toolTip = {}) {
    widget->setObjectName(objectName);
    widget->setAccessibleName(accessibleName);
    widget->setToolTip(toolTip);
    return widget;
}

/// Enables a control or an action of a menu, or disables it. While it is disabled its tool tip ends with the sentence
/// `whyNot`. A tool tip that is set meanwhile is its new meaning.
void enableOrSayWhy(QWidget& control, bool enabled, const QString& whyNot);
void enableOrSayWhy(QAction& action, bool enabled, const QString& whyNot);

/// The tool tip of a control without the sentence that enableOrSayWhy() has put behind it.
[[nodiscard]] QString meaningOf(const QWidget& control);
[[nodiscard]] QString meaningOf(const QAction& action);

/// A tool tip that shows any text as it is, also one that looks like HTML.
[[nodiscard]] QString literalToolTip(const QString& text);
/// A text of a menu or button that shows any text as it is: no "&" in it marks a key.
[[nodiscard]] QString literalMenuText(QString text);

/// Lets the wheel change a control only while the control has the focus. So scrolling a dock changes no value by
/// accident.
void wheelNeedsFocus(QWidget* control);

/// A text in front of a control. The control is its buddy.
[[nodiscard]] QLabel* labelFor(QWidget* control, const QString& text);

/// A small button with a bent arrow that resets something. `what` is its accessible name and its tool tip.
[[nodiscard]] QToolButton* resetButton(const QString& objectName, const QString& what);

/// A less prominent text.
[[nodiscard]] QLabel* secondaryLabel(const QString& text = {});

/// A sentence to read before saving something, in as many lines as it needs.
[[nodiscard]] QLabel* noteLabel(const QString& sentence, const QString& objectName);

/// "+3°", "−3°", "0°".
[[nodiscard]] QString angleText(int degrees);

/// Shows how much of a run is done: a share, clamped to [0,1]. NaN means that nobody knows the share, and changes
/// nothing.
void showShare(QProgressBar* progress, double share);

/// Selects the entry with that data; emits nothing. The data must be there.
void selectData(QComboBox* comboBox, int data);

}  // namespace echolucent
