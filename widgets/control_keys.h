// Which keys belong to the focused control, and not to the window; and who gets the focus by a click.
#pragma once

#include <QObject>

class QKeyEvent;
class QWidget;

namespace echolucent {

/// Whether a control uses a key itself, so that no shortcut of the window may take it: Space of a button, the arrows of
/// sliders, radio buttons, lists and tabs, the digits of a table. Text fields say so themselves.
[[nodiscard]] bool wantsKey(const QWidget& control, const QKeyEvent& key);

/// Keeps the keys of the focused control from the shortcuts of its window, in the whole application.
///
/// Buttons of windows that are no dialogs take the focus by Tab, not by a click. A click on one takes the focus from
/// the control that had it, so that a field takes what was typed. A picture keeps the focus.
class ControlKeys : public QObject {
    Q_OBJECT

public:
    explicit ControlKeys(QObject* parent = nullptr);
    bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace echolucent
