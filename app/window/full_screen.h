// Shows the picture alone on the whole screen.
#pragma once

#include <QByteArray>
#include <QList>
#include <QObject>
#include <QPointer>
#include <QWidget>

class QMainWindow;

namespace echolucent {

/// Hides the window's docks, tool bars, menu bar and status bar, and `panels` of its central widget. Shows them again
/// exactly as they were.
class FullScreen : public QObject {
    Q_OBJECT

public:
    FullScreen(QMainWindow& window, const QList<QWidget*>& panels);

    [[nodiscard]] bool active() const { return m_active; }
    void toggle();
    /// False if the window is not on the full screen.
    bool leave();

signals:
    /// What changed on the full screen may go back, so that all finds the place that it had before.
    void aboutToLeave();
    void changed();

private:
    void enter();

    QMainWindow& m_window;
    QList<QWidget*> m_panels;
    QList<QPointer<QWidget>> m_hidden;  ///< what was visible before, except for docks
    QByteArray m_docks;                 ///< as QMainWindow::saveState() gave them
    Qt::WindowStates m_windowState;
    bool m_active = false;
};

}  // namespace echolucent
