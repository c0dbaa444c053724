// The panel of the window in which a control stands.
#pragma once

#include <QDockWidget>
#include <type_traits>

namespace echolucent {

/// The dock around a widget, or the widget if it is one; null if there is none.
template <typename Widget>
[[nodiscard]] auto dockAround(Widget* widget) {
    auto* around = static_cast<std::conditional_t<std::is_const_v<Widget>, const QWidget, QWidget>*>(widget);
    while (around != nullptr && qobject_cast<const QDockWidget*>(around) == nullptr) around = around->parentWidget();
    return static_cast<std::conditional_t<std::is_const_v<Widget>, const QDockWidget, QDockWidget>*>(around);
}

}  // namespace echolucent
