// A hand that does by chance what a person can do with the controls and pictures of the window.
#pragma once

#include <QEvent>
#include <QList>
#include <QPointer>
#include <QTimer>
#include <functional>

#include "app/window/main_window.h"
#include "tests/app/stress/random_choice.h"

namespace echolucent {

/// Every function returns what was done, for the log; an empty text where there was nothing to do it with.
class WindowHand {
public:
    explicit WindowHand(MainWindow& window);

    /// Drags over a picture, a plane, a curve or a plot; now and then Escape ends it. `meanwhile` is called halfway.
    QString drag(RandomChoice& choice, const std::function<void()>& meanwhile = {});
    QString turnWheel(RandomChoice& choice);
    QString doubleClick(RandomChoice& choice);
    /// Keys that a picture, a plane or a curve takes.
    QString pressKeys(RandomChoice& choice);
    /// Turns a control of a panel that is in sight.
    QString turnControl(RandomChoice& choice) { return turnControl(choice, m_window); }
    /// The same of the controls inside a widget.
    QString turnControl(RandomChoice& choice, const QWidget& within);
    /// Brings a panel to the front and turns a control of it.
    QString turnControlOf(RandomChoice& choice, const QString& dock);
    QString raisePanel(RandomChoice& choice);
    /// Triggers an entry of the menus that neither asks for a file nor ends the program.
    QString triggerAction(RandomChoice& choice);
    /// Opens a dialog, which is dismissed at once.
    QString askAndDismiss(RandomChoice& choice);
    /// Closes menus and dialogs that are still open.
    void dismissDialogs();

private:
    /// What takes the mouse: a widget, or the OpenGL window of the 3D view.
    struct Target {
        QPointer<QObject> object;
        QSize size;
        std::function<QPointF(const QPointF&)> toGlobal;
    };
    [[nodiscard]] QList<Target> targets() const;
    [[nodiscard]] QList<QAction*> actions(bool asking) const;
    void send(const Target& target, QEvent::Type type, const QPointF& place, Qt::MouseButton button,
              Qt::MouseButtons held, Qt::KeyboardModifiers keys) const;
    void press(QWidget* widget, Qt::Key key, Qt::KeyboardModifiers modifiers = {}) const;

    MainWindow& m_window;
    QTimer m_dismissing;  ///< a dialog that runs a loop of its own is dismissed in it
};

}  // namespace echolucent
