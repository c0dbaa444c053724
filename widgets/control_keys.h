// Which keys belong to the control that has the focus, and not to the window.
#pragma once

#include <QObject>

class QKeyEvent;
class QWidget;

namespace echolucent {

/// Whether a control does something of its own with a key, so that no shortcut of the window may take it: Space of a
/// button, the arrows of sliders, radio buttons, lists and tabs, the digits of a table. Fields of text say so
/// themselves.
[[nodiscard]] bool wantsKey(const QWidget& control, const QKeyEvent& key);

/// Keeps, in the whole application, the keys of the control that has the focus from the shortcuts of its window.
class ControlKeys : public QObject {
    Q_OBJECT

public:
    explicit ControlKeys(QObject* parent = nullptr);
    bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace echolucent
