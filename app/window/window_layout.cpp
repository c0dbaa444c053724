#include "app/window/window_layout.h"

#include <QDockWidget>
#include <QEvent>
#include <QMainWindow>
#include <QScrollArea>
#include <QScrollBar>
#include <QStackedWidget>
#include <QStatusBar>
#include <QVBoxLayout>

#include "widgets/compare/compare_grid.h"
#include "widgets/compare/compare_panel.h"
#include "widgets/controls/message_bar.h"
#include "widgets/controls/run_status.h"
#include "widgets/motion/otf_course_panel.h"
#include "widgets/otf_editor/otf_editor.h"
#include "widgets/panels/curve_sliders.h"
#include "widgets/panels/designer_panel.h"
#include "widgets/panels/explain_panel.h"
#include "widgets/panels/history_panel.h"
#include "widgets/panels/measurements_panel.h"
#include "widgets/panels/method_panel.h"
#include "widgets/panels/motion_panel.h"
#include "widgets/panels/presets_panel.h"
#include "widgets/panels/room_panel.h"
#include "widgets/panels/study_panel.h"
#include "widgets/panels/view_panel.h"
#include "widgets/planes/pane_grid.h"
#include "widgets/planes/plane_pane.h"
#include "widgets/volume_view/volume_view_widget.h"

namespace echolucent {

namespace {

/// Width of the column of panels at the start, logical pixels. At 1280 the picture keeps more than 70 % of the window.
constexpr int columnWidth = 340;

/// Scrolls a panel up and down only. It is never narrower than the panel, whose fields grow with their content, so that
/// the panel's right edge stays visible.
class PanelScrollArea : public QScrollArea {
public:
    PanelScrollArea(QWidget* panel, QWidget* parent) : QScrollArea(parent) {
        setFrameShape(QFrame::NoFrame);
        setFocusPolicy(Qt::NoFocus);  // the controls inside take the focus
        setWidgetResizable(true);
        setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
        setWidget(panel);
        followWidth();
    }

    bool eventFilter(QObject* watched, QEvent* event) override {
        if (watched == widget() && event->type() == QEvent::LayoutRequest) followWidth();
        return QScrollArea::eventFilter(watched, event);
    }

private:
    void followWidth() {
        setMinimumWidth(widget()->minimumSizeHint().width() + verticalScrollBar()->sizeHint().width());
    }
};

QDockWidget* addDock(QMainWindow& window, const QString& title, const QString& name, QWidget* content) {
    auto* dock = new QDockWidget(title, &window);
    dock->setObjectName(name);
    dock->setWidget(new PanelScrollArea(content, dock));
    window.addDockWidget(Qt::RightDockWidgetArea, dock);
    return dock;
}

/// The controls that a person turns first stand on top.
QWidget* pictureContent(const WindowLayout& layout) {
    auto* content = new QWidget;
    auto* column = new QVBoxLayout(content);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(layout.presets);
    column->addWidget(layout.sliders);
    column->addWidget(layout.controls, 1);
    return content;
}

/// The measurements stand above the controls that are set once, so that their list is visible while measuring.
QWidget* planesContent(const WindowLayout& layout) {
    auto* content = new QWidget;
    auto* column = new QVBoxLayout(content);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(layout.measurements);
    column->addWidget(layout.room, 1);
    return content;
}

/// What was read, and below it the steps done with it.
QWidget* studyContent(const WindowLayout& layout) {
    auto* content = new QWidget;
    auto* column = new QVBoxLayout(content);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(layout.facts, 3);
    column->addWidget(layout.history, 2);
    return content;
}

/// One column of panels, tabbed by a person's tasks. Opening one makes nothing grow beside the 3D view.
void arrangeDocks(QMainWindow& window, WindowLayout& layout) {
    const auto title = [](const char* text) { return QMainWindow::tr(text); };
    window.setTabPosition(Qt::RightDockWidgetArea, QTabWidget::North);
    QDockWidget* picture = addDock(window, title("Picture"), "dock.view", pictureContent(layout));
    QDockWidget* curve = addDock(window, title("Curve"), "dock.otfEditor", layout.editor);
    QDockWidget* room = addDock(window, title("Planes"), "dock.room", planesContent(layout));
    QDockWidget* method = addDock(window, title("Method"), "dock.method", layout.method);
    QDockWidget* designers = addDock(window, title("Designers"), "dock.designers", layout.designers);
    layout.compareDock = addDock(window, title("Compare"), "dock.compare", layout.compare);
    layout.studyDock = addDock(window, title("Study"), "dock.study", studyContent(layout));
    layout.courseDock = addDock(window, title("Motion"), "dock.motionMap", layout.course);
    layout.explainDock = addDock(window, title("Explain"), "dock.explain", layout.explain);
    for (QDockWidget* dock :
         {curve, room, method, designers, layout.compareDock, layout.studyDock, layout.courseDock, layout.explainDock})
        window.tabifyDockWidget(picture, dock);
    layout.compareDock->hide();
    layout.courseDock->hide();
    layout.explainDock->hide();
    picture->raise();
    window.resizeDocks({picture}, {columnWidth}, Qt::Horizontal);
}

}  // namespace

WindowLayout layOut(QMainWindow& window, Works& works, DocumentModel& document, const OtfCourse& course) {
    auto* centre = new QWidget(&window);
    auto* column = new QVBoxLayout(centre);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    WindowLayout layout;
    for (const PlaneName plane : allPlaneNames) layout.planes[indexOf(plane)] = new PlanePane(plane, centre);
    layout.picture = new VolumeViewWidget(works, centre);
    layout.panes = new PaneGrid({layout.planes[0], layout.planes[1], layout.planes[2], layout.picture}, centre);
    layout.compared = new CompareGrid(centre);
    layout.rooms = new QStackedWidget(centre);
    layout.rooms->addWidget(layout.panes);
    layout.rooms->addWidget(layout.compared);
    layout.motion = new MotionPanel(centre);
    column->addWidget(layout.rooms, 1);
    column->addWidget(layout.motion);
    window.setCentralWidget(centre);
    layout.messages = new MessageBar(centre);
    layout.messages->lieOver(*layout.picture);

    layout.editor = new OtfEditor(document, &window);
    layout.method = new MethodPanel(&window);
    layout.designers = new DesignerPanel(document, &window);
    layout.controls = new ViewPanel(&window);
    layout.presets = new PresetsPanel(&window);
    layout.sliders = new CurveSliders(document, &window);
    QObject::connect(layout.sliders, &CurveSliders::resetRequested, layout.editor->resetAction(), &QAction::trigger);
    layout.room = new RoomPanel(document, &window);
    layout.measurements = new MeasurementsPanel(&window);
    layout.compare = new ComparePanel(&window);
    layout.facts = new StudyPanel(&window);
    layout.course = new OtfCoursePanel(course, &window);
    layout.explain = new ExplainPanel(&window);
    layout.history = new HistoryPanel(document.steps(), &window);
    arrangeDocks(window, layout);

    layout.status = new RunStatus(&window);
    window.statusBar()->addWidget(layout.status, 1);
    window.statusBar()->setSizeGripEnabled(false);
    return layout;
}

}  // namespace echolucent
