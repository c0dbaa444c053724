#include "app/window/window_layout.h"

#include <QAction>
#include <QDockWidget>
#include <QEvent>
#include <QMainWindow>
#include <QScrollArea>
#include <QScrollBar>
#include <QStackedWidget>
#include <QStatusBar>
#include <QVBoxLayout>
#include <stdexcept>
#include <vector>

#include "app/window/dock_title.h"
#include "widgets/compare/compare_grid.h"
#include "widgets/compare/compare_panel.h"
#include "widgets/controls/message_bar.h"
#include "widgets/controls/opening_label.h"
#include "widgets/controls/run_status.h"
#include "widgets/controls/side_strip.h"
#include "widgets/lesson/lessons_panel.h"
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
#include "widgets/theory/theory_panel.h"
#include "widgets/tube_cores/tube_core_panel.h"
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

/// The rooms with the strip of sides: left of them, or below them if they would else be narrow.
class RoomsWithStrip : public QWidget {
public:
    RoomsWithStrip(SideStrip* strip, QWidget* rooms, QWidget* parent) : QWidget(parent), m_strip(strip) {
        m_row = new QBoxLayout(QBoxLayout::LeftToRight, this);
        m_row->setContentsMargins(0, 0, 0, 0);
        m_row->setSpacing(0);
        m_row->addWidget(strip);
        m_row->addWidget(rooms, 1);
    }

protected:
    void resizeEvent(QResizeEvent* event) override {
        QWidget::resizeEvent(event);
        // At 1280 pixels 940 are left beside the column of panels; at 1024 they are 684, and the picture keeps 60 %
        // only with the strip below.
        constexpr int narrow = 780;
        const bool below = width() < narrow;
        const auto direction = below ? QBoxLayout::BottomToTop : QBoxLayout::LeftToRight;
        if (direction == m_row->direction()) return;
        m_row->setDirection(direction);
        m_strip->setOrientation(below ? Qt::Horizontal : Qt::Vertical);
        m_row->activate();  // not a frame later
    }

private:
    QBoxLayout* m_row;
    SideStrip* m_strip;
};

/// A dock of the column: its panels from top to bottom.
struct Dock {
    const char* title;
    const char* name;
    const char* holds;  ///< for the tool tip of its name
    std::vector<QWidget*> panels;
    std::vector<int> stretches{1};  ///< of the panels; 0: as high as it needs to be
    bool shown = false;             ///< at the first start, in the face Review
};

QWidget* contentOf(const Dock& dock) {
    if (dock.panels.size() == 1) return dock.panels.front();
    auto* content = new QWidget;
    auto* column = new QVBoxLayout(content);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    for (std::size_t i = 0; i < dock.panels.size(); ++i) column->addWidget(dock.panels[i], dock.stretches.at(i));
    return content;
}

/// One column of panels, tabbed by a person's tasks. Opening one makes nothing grow beside the 3D view. The first dock
/// is in front. Returns them in their order.
QList<QDockWidget*> addDocks(QMainWindow& window, const std::vector<Dock>& docks) {
    window.setTabPosition(Qt::RightDockWidgetArea, QTabWidget::North);
    QList<QDockWidget*> made;
    for (const Dock& each : docks) {
        auto* dock = new QDockWidget(QMainWindow::tr(each.title), &window);
        dock->setObjectName(each.name);
        dock->toggleViewAction()->setToolTip(QMainWindow::tr(each.holds));
        dock->setWidget(new PanelScrollArea(contentOf(each), dock));
        window.addDockWidget(Qt::RightDockWidgetArea, dock);
        if (!made.isEmpty()) window.tabifyDockWidget(made.front(), dock);
        if (!each.shown) dock->hide();
        made << dock;
    }
    for (QDockWidget* dock : made) dock->setTitleBarWidget(new DockTitle(window, *dock, made));
    made.front()->raise();
    window.resizeDocks({made.front()}, {columnWidth}, Qt::Horizontal);
    return made;
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
    layout.sides = new SideStrip(centre);
    column->addWidget(new RoomsWithStrip(layout.sides, layout.rooms, centre), 1);
    column->addWidget(layout.motion);
    window.setCentralWidget(centre);
    layout.messages = new MessageBar(centre);
    layout.messages->lieOver(*layout.picture);
    layout.opening = new OpeningLabel(centre);

    layout.editor = new OtfEditor(document, &window);
    layout.method = new MethodPanel(&window);
    layout.designers = new DesignerPanel(document, &window);
    layout.controls = new ViewPanel(&window);
    layout.presets = new PresetsPanel(&window);
    auto* sliders = layout.sliders = new CurveSliders(document, &window);
    QObject::connect(sliders, &CurveSliders::resetRequested, layout.editor->resetAction(), &QAction::trigger);
    layout.room = new RoomPanel(document, &window);
    layout.measurements = new MeasurementsPanel(&window);
    layout.compare = new ComparePanel(&window);
    layout.facts = new StudyPanel(&window);
    layout.course = new OtfCoursePanel(course, &window);
    layout.explain = new ExplainPanel(&window);
    layout.theory = new TheoryPanel(&window);
    layout.tubeCores = new TubeCorePanel(&window);
    layout.history = new HistoryPanel(document.steps(), &window);
    layout.lessons = new LessonsPanel(&window);
    const std::vector<Dock> docks{
        // What a person turns first stands on top.
        {.title = "Picture",
         .name = "dock.view",
         .holds = "Presets, threshold, transparency, brightness, smoothing, light and the front",
         .panels = {layout.presets, sliders, layout.controls},
         .stretches = {0, 0, 1},
         .shown = true},
        {"Curve",
         "dock.otfEditor",
         "Which echoes show, and how strongly: the curve over the histogram",
         {layout.editor}},
        // The list of measurements is visible while measuring, above what is set once.
        {.title = "Measure",
         .name = "dock.room",
         .holds = "Measurements, scalpel, box and planes",
         .panels = {layout.measurements, layout.room},
         .stretches = {0, 1},
         .shown = true},
        {"Method", "dock.method", "The parameters of the adaptive OTF, and what it found", {layout.method}},
        {"Tube cores",
         "dock.tubeCores",
         "What each tube core found, and what it does to the curve",
         {layout.tubeCores}},
        {"Designers", "dock.designers", "Other ways to make the OTF", {layout.designers}},
        {"Compare", "dock.compare", "Two to four OTFs under one camera, and their measures", {layout.compare}},
        {.title = "Study",
         .name = "dock.study",
         .holds = "What the file says, the history and its snapshots",
         .panels = {layout.facts, layout.history},
         .stretches = {3, 2},
         .shown = true},
        {"Motion", "dock.motionMap", "The OTF over the angle or the volume", {layout.course}},
        {"Explain", "dock.explain", "What the picture shows, and why (F1)", {layout.explain}},
        {"Theory", "dock.theory", "The contrast of two intensities under five curves", {layout.theory}},
        {"Lessons", "dock.lessons", "Lessons on simulated scans, step by step", {layout.lessons}},
    };
    layout.docks = addDocks(window, docks);

    layout.status = new RunStatus(&window);
    window.statusBar()->addWidget(layout.status, 1);
    window.statusBar()->setSizeGripEnabled(false);
    return layout;
}

QDockWidget& dockOf(const QWidget& panel) {
    for (QWidget* above = panel.parentWidget(); above != nullptr; above = above->parentWidget())
        if (auto* dock = qobject_cast<QDockWidget*>(above)) return *dock;
    throw std::invalid_argument("dockOf: the panel stands in no dock");
}

void showDockOf(const QWidget& panel) {
    dockOf(panel).show();
    dockOf(panel).raise();
}

}  // namespace echolucent
