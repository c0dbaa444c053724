#include "app/window/full_screen.h"

#include <QDockWidget>
#include <QMainWindow>
#include <QMenuBar>
#include <QStatusBar>
#include <QToolBar>
#include <utility>

namespace echolucent {

FullScreen::FullScreen(QMainWindow& window, const QList<QWidget*>& panels)
    : QObject(&window), m_window(window), m_panels(panels) {}

void FullScreen::toggle() {
    if (!leave()) enter();
}

void FullScreen::enter() {
    m_active = true;
    m_docks = m_window.saveState();
    m_windowState = m_window.windowState();
    QList<QWidget*> around{m_window.menuBar(), m_window.statusBar()};
    for (auto* bar : m_window.findChildren<QToolBar*>(Qt::FindDirectChildrenOnly)) around << bar;
    around += m_panels;
    for (QWidget* widget : around) {
        if (widget->isHidden()) continue;
        m_hidden << widget;
        widget->hide();
    }
    for (auto* dock : m_window.findChildren<QDockWidget*>(Qt::FindDirectChildrenOnly)) dock->hide();
    m_window.setWindowState(m_windowState | Qt::WindowFullScreen);
    emit changed();
}

bool FullScreen::leave() {
    if (!std::exchange(m_active, false)) return false;
    emit aboutToLeave();
    m_window.setWindowState(m_windowState);
    for (const QPointer<QWidget>& widget : std::exchange(m_hidden, {}))
        if (widget) widget->show();
    m_window.restoreState(m_docks);
    emit changed();
    return true;
}

}  // namespace echolucent
