// The window's menus; their keys stand in the table of keys.
#pragma once

#include <QList>
#include <QString>
#include <functional>

class QAction;
class QDockWidget;
class QMainWindow;
class QMenu;

namespace echolucent {

class OtfEditor;

/// What the menus' own actions do; the OTF editor brings its actions along.
struct WindowCommands {
    std::function<void()> openFile, openFolder, openRawFile, chooseSeries, openSimulatedScan, savePicture, savePanes,
        saveMovie, savePictureSeries, saveReport, copyPicture, resetView, resetAll, computeForThisView, playOrPause,
        explain, nextLighting, frontFromHere, findFront, noFront, toggleFullScreen;
    std::function<void()> saveSession, saveSessionAs, showHistory;
    std::function<void(int levels)> reduceSpeckle;  ///< by `levels` more; less if negative
    std::function<void(int degrees)> turnMotion;
    std::function<void(int step)> stepPhase;  ///< -1 or 1
    std::function<void(bool numbers)> numbersForNames;
    std::function<void(bool light)> lightTheme;
    std::function<void(bool large)> largePointer;
    std::function<void(bool shown)> showSides;
    QList<QAction*> sides;  ///< take the six sides
    std::function<void(QMenu&menu)> fillRecentFiles, fillLeftUnsaved;
};

/// Fills the menu bar. `panels` are all docks in their order. `course` is the dock of the OTF over the angle. It has an
/// action of its own besides that of every dock.
void createMenus(QMainWindow& window, OtfEditor& editor, const QList<QDockWidget*>& panels, QDockWidget& course,
                 const WindowCommands& commands);

}  // namespace echolucent
