// The window's menus and the keys that stand in them.
#pragma once

#include <QString>
#include <functional>

class QDockWidget;
class QMainWindow;
class QMenu;

namespace echolucent {

class OtfEditor;

/// What the menus' own actions do; the OTF editor brings its actions along.
struct WindowCommands {
    std::function<void()> openFile, openFolder, openRawFile, openSimulatedScan, savePicture, resetView,
        computeForThisView, playOrPause, explain, nextLighting, toggleNearCut;
    std::function<void(int levels)> reduceSpeckle;  ///< by so many levels more; less where it is negative
    std::function<void(int degrees)> turnMotion;
    std::function<void(QMenu& menu)> fillRecentFiles;
};

/// A box of text beside the window that waits for nobody.
void showText(QMainWindow& window, const QString& name, const QString& title, const QString& text);

/// Fills the menu bar. `course` is the dock of the OTF over the angle, which has an action of its own beside that of
/// every dock.
void createMenus(QMainWindow& window, OtfEditor& editor, QDockWidget& course, const WindowCommands& commands);

}  // namespace echolucent
