// The workstation's real window with a study, for measurements.
#pragma once

#include <QAction>
#include <QTemporaryDir>
#include <QWindow>
#include <functional>
#include <memory>

#include "app/window/main_window.h"

namespace echolucent::bench {

/// Runs the event loop until `done`. Ends the program if that does not happen.
void await(const char* what, const std::function<bool()>& done);

/// A main window with settings of its own, not shown yet. Measurements inherit it.
class OpenWindow {
protected:
    OpenWindow();

    [[nodiscard]] MainWindow& window() const { return *m_window; }
    [[nodiscard]] VolumeViewWidget& view() const { return m_window->volumeView(); }
    /// The OpenGL window of the 3D view, which receives the mouse.
    [[nodiscard]] QWindow* pictureWindow() const;
    template <typename Widget>
    [[nodiscard]] Widget* child(const QString& name) const {
        auto* found = m_window->findChild<Widget*>(name);
        if (found == nullptr) qFatal("no %s", qPrintable(name));
        return found;
    }
    void trigger(const QString& action) { child<QAction>(action)->trigger(); }

    void show();
    void openVolume(const QString& path);
    void waitUntilConverged();
    /// Draws an outline in the 3D view with the scalpel, and puts the scalpel away.
    void drawStroke();

private:
    QTemporaryDir m_folder;
    std::unique_ptr<MainWindow> m_window;
};

}  // namespace echolucent::bench
