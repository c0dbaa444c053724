#include "app/window/window_layout.h"

#include <QDockWidget>
#include <QMainWindow>
#include <QScrollArea>
#include <QScrollBar>
#include <QStatusBar>
#include <QVBoxLayout>

#include "widgets/motion/otf_course_panel.h"
#include "widgets/otf_editor/otf_editor.h"
#include "widgets/panels/curve_sliders.h"
#include "widgets/panels/message_bar.h"
#include "widgets/panels/method_panel.h"
#include "widgets/panels/motion_panel.h"
#include "widgets/panels/room_panel.h"
#include "widgets/panels/run_status.h"
#include "widgets/panels/study_panel.h"
#include "widgets/panels/view_panel.h"
#include "widgets/planes/pane_grid.h"
#include "widgets/planes/plane_pane.h"
#include "widgets/volume_view/volume_view_widget.h"

namespace echolucent {

namespace {

QDockWidget* addDock(QMainWindow& window, const QString& title, const QString& name, QWidget* content) {
    auto* dock = new QDockWidget(title, &window);
    dock->setObjectName(name);
    auto* scroll = new QScrollArea(dock);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setWidgetResizable(true);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setWidget(content);
    // Panels scroll up and down only, so that nothing at their right edge is ever out of sight.
    scroll->setMinimumWidth(content->minimumSizeHint().width() + scroll->verticalScrollBar()->sizeHint().width());
    dock->setWidget(scroll);
    window.addDockWidget(Qt::RightDockWidgetArea, dock);
    return dock;
}

/// What the person turns first stands on top.
QWidget* pictureContent(const WindowLayout& layout) {
    auto* content = new QWidget;
    auto* column = new QVBoxLayout(content);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(layout.sliders);
    column->addWidget(layout.controls, 1);
    return content;
}

void arrangeDocks(QMainWindow& window, WindowLayout& layout) {
    const auto title = [](const char* text) { return QMainWindow::tr(text); };
    QDockWidget* otf = addDock(window, title("Opacity transfer function"), "dock.otfEditor", layout.editor);
    QDockWidget* picture = addDock(window, title("Picture"), "dock.view", pictureContent(layout));
    QDockWidget* room = addDock(window, title("Planes and box"), "dock.room", layout.room);
    QDockWidget* method = addDock(window, title("Adaptive"), "dock.method", layout.method);
    QDockWidget* study = addDock(window, title("Study"), "dock.study", layout.facts);
    layout.courseDock = addDock(window, title("OTF over angle"), "dock.motionMap", layout.course);
    window.splitDockWidget(otf, picture, Qt::Vertical);
    // Behind the editor, so that nothing beside the 3D view grows when it opens.
    window.tabifyDockWidget(otf, layout.courseDock);
    layout.courseDock->hide();
    window.tabifyDockWidget(picture, room);
    window.tabifyDockWidget(room, method);
    window.tabifyDockWidget(method, study);
    picture->raise();
    window.resizeDocks({otf, picture}, {560, 300}, Qt::Vertical);
    window.resizeDocks({otf, picture}, {430, 430}, Qt::Horizontal);
}

}  // namespace

WindowLayout layOut(QMainWindow& window, CurveOwner& curves, const OtfCourse& course) {
    auto* centre = new QWidget(&window);
    auto* column = new QVBoxLayout(centre);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    WindowLayout layout;
    // The bar stands above the picture, not on it: a native OpenGL window covers its sibling widgets.
    layout.messages = new MessageBar(centre);
    for (const PlaneName plane : allPlaneNames) layout.planes[indexOf(plane)] = new PlanePane(plane, centre);
    layout.picture = new VolumeViewWidget(centre);
    layout.panes = new PaneGrid({layout.planes[0], layout.planes[1], layout.planes[2], layout.picture}, centre);
    layout.motion = new MotionPanel(centre);
    column->addWidget(layout.messages);
    column->addWidget(layout.panes, 1);
    column->addWidget(layout.motion);
    window.setCentralWidget(centre);

    layout.editor = new OtfEditor(curves, &window);
    layout.method = new MethodPanel(&window);
    layout.controls = new ViewPanel(&window);
    layout.sliders = new CurveSliders(&window);
    layout.room = new RoomPanel(&window);
    layout.facts = new StudyPanel(&window);
    layout.course = new OtfCoursePanel(course, &window);
    arrangeDocks(window, layout);

    layout.status = new RunStatus(&window);
    window.statusBar()->addWidget(layout.status, 1);
    window.statusBar()->setSizeGripEnabled(false);
    return layout;
}

}  // namespace echolucent
