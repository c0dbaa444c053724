// The tool bar: what a sonographer reaches for, as pictures with words, and the switch between the two faces.
#pragma once

class QDockWidget;
class QMainWindow;

namespace echolucent {

class DocumentModel;
class OpenStudy;
class WindowFaces;

struct ToolBarParts {
    QMainWindow& window;  ///< with its menus, whose actions the buttons trigger
    DocumentModel& document;
    OpenStudy& openStudy;
    WindowFaces& faces;
    QDockWidget& curve;  ///< the dock of the curve editor
};

/// Puts the bar into the window. Objects: toolBar, toolBar.open, .sides, .layout, .box, .front, .scalpel, .measure,
/// .curve, .save, .reset, the menu menu.sides, and face.review and face.teach. One of these two is checked.
/// A button that can do nothing is greyed, and its tool tip says why.
void createToolBar(const ToolBarParts& parts);

}  // namespace echolucent
