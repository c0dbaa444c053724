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

/// Scrolls the content of a dock up and down only. It is never narrower than the content, whose fields grow, so that
/// the content's right edge stays visible. Content is laid out when its dock is first shown: a panel that nobody opens
/// takes no time at the start.
class PanelScrollArea : public QScrollArea {
public:
    explicit PanelScrollArea(QDockWidget* dock) : QScrollArea(dock), m_dock(dock) {
        setFrameShape(QFrame::NoFrame);
        setFocusPolicy(Qt::NoFocus);  // the controls inside take the focus
        setWidgetResizable(true);
        setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
        dock->setWidget(this);
        dock->installEventFilter(this);
    }

    [[nodiscard]] QDockWidget* dock() const { return m_dock; }
    /// `content` is a child of viewport(): a widget that changes its parent asks for the style of all in it again.
    void scroll(QWidget* content) { m_content = content; }
    void layOutContent() {
        m_dock->removeEventFilter(this);
        if (widget() != nullptr) return;
        // An area asks a widget without a size for the one that it would like, and does not use it.
        m_content->resize(m_dock->size());
        setWidget(m_content);
        followWidth();
    }

    bool eventFilter(QObject* watched, QEvent* event) override {
        // Sent also where the window itself is not shown yet, before the docks share the width of the column.
        if (watched == m_dock && event->type() == QEvent::ShowToParent) layOutContent();
        if (watched == widget() && event->type() == QEvent::LayoutRequest) followWidth();
        return QScrollArea::eventFilter(watched, event);
    }

private:
    void followWidth() {
        setMinimumWidth(widget()->minimumSizeHint().width() + verticalScrollBar()->sizeHint().width());
    }

    QDockWidget* m_dock;
    QWidget* m_content = nullptr;
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

/// A dock of the column.
struct Dock {
    const char* title;
    const char* name;
    const char* holds;   ///< for the tool tip of its name
    bool shown = false;  ///< at the first start, in the face Review
};

/// One column of docks, tabbed by a person's tasks. Opening one makes nothing grow beside the 3D view.
class DockColumn {
public:
    explicit DockColumn(QMainWindow& window) : m_window(window) {
        window.setTabPosition(Qt::RightDockWidgetArea, QTabWidget::North);
    }

    /// Adds a dock that holds one panel, made of these arguments and its parent.
    template <typename Panel, typename... Arguments>
    Panel* add(const Dock& dock, Arguments&... arguments) {
        PanelScrollArea& area = addDock(dock);
        auto* panel = new Panel(arguments..., area.viewport());
        area.scroll(panel);
        return panel;
    }
    /// Adds a dock that holds panels from top to bottom. They are children of the layout's parentWidget().
    QVBoxLayout* addColumn(const Dock& dock) {
        PanelScrollArea& area = addDock(dock);
        auto* content = new QWidget(area.viewport());
        auto* column = new QVBoxLayout(content);
        column->setContentsMargins(0, 0, 0, 0);
        column->setSpacing(0);
        area.scroll(content);
        return column;
    }
    /// Puts the docks into the window, the first one in front, and returns them in their order.
    QList<QDockWidget*> arrange() {
        QList<QDockWidget*> docks;
        for (const auto& [area, shown] : m_areas) {
            if (shown) area->layOutContent();
            QDockWidget* dock = area->dock();
            m_window.addDockWidget(Qt::RightDockWidgetArea, dock);
            if (!docks.isEmpty()) m_window.tabifyDockWidget(docks.front(), dock);
            if (!shown) dock->hide();
            docks << dock;
        }
        for (QDockWidget* dock : docks) dock->setTitleBarWidget(new DockTitle(m_window, *dock, docks));
        docks.front()->raise();
        m_window.resizeDocks({docks.front()}, {columnWidth}, Qt::Horizontal);
        return docks;
    }

private:
    struct Area {
        PanelScrollArea* area;
        bool shown;
    };

    PanelScrollArea& addDock(const Dock& dock) {
        auto* widget = new QDockWidget(QMainWindow::tr(dock.title), &m_window);
        widget->setObjectName(dock.name);
        widget->toggleViewAction()->setObjectName(QLatin1String(dock.name) + QStringLiteral(".shown"));
        widget->toggleViewAction()->setToolTip(QMainWindow::tr(dock.holds));
        m_areas.push_back({new PanelScrollArea(widget), dock.shown});
        return *m_areas.back().area;
    }

    QMainWindow& m_window;
    std::vector<Area> m_areas;
};

/// The docks with their panels.
void addPanels(WindowLayout& layout, QMainWindow& window, DocumentModel& document, const OtfCourse& course) {
    DockColumn docks(window);
    // What a person turns first stands on top.
    QVBoxLayout* picture =
        docks.addColumn({.title = "Picture",
                         .name = "dock.view",
                         .holds = "Presets, threshold, transparency, brightness, smoothing, light and the front",
                         .shown = true});
    picture->addWidget(layout.presets = new PresetsPanel(picture->parentWidget()));
    picture->addWidget(layout.sliders = new CurveSliders(document, picture->parentWidget()));
    picture->addWidget(layout.controls = new ViewPanel(picture->parentWidget()), 1);
    layout.editor = docks.add<OtfEditor>(
        {"Curve", "dock.otfEditor", "Which echoes show, and how strongly: the curve over the histogram"}, document);
    QObject::connect(layout.sliders, &CurveSliders::resetRequested, layout.editor->resetAction(), &QAction::trigger);
    // The list of measurements is visible while measuring, above what is set once.
    QVBoxLayout* measure = docks.addColumn(
        {.title = "Measure", .name = "dock.room", .holds = "Measurements, scalpel, box and planes", .shown = true});
    measure->addWidget(layout.measurements = new MeasurementsPanel(measure->parentWidget()));
    measure->addWidget(layout.room = new RoomPanel(document, measure->parentWidget()), 1);
    layout.method =
        docks.add<MethodPanel>({"Method", "dock.method", "The parameters of the adaptive OTF, and what it found"});
    layout.tubeCores = docks.add<TubeCorePanel>(
        {"Tube cores", "dock.tubeCores", "What each tube core found, and what it does to the curve"});
    layout.designers =
        docks.add<DesignerPanel>({"Designers", "dock.designers", "Other ways to make the OTF"}, document);
    layout.compare =
        docks.add<ComparePanel>({"Compare", "dock.compare", "Two to four OTFs under one camera, and their measures"});
    QVBoxLayout* study = docks.addColumn({.title = "Study",
                                          .name = "dock.study",
                                          .holds = "What the file says, the history and its snapshots",
                                          .shown = true});
    study->addWidget(layout.facts = new StudyPanel(study->parentWidget()), 3);
    study->addWidget(layout.history = new HistoryPanel(document.steps(), study->parentWidget()), 2);
    layout.course =
        docks.add<OtfCoursePanel>({"Motion", "dock.motionMap", "The OTF over the angle or the volume"}, course);
    layout.explain = docks.add<ExplainPanel>({"Explain", "dock.explain", "What the picture shows, and why (F1)"});
    layout.theory =
        docks.add<TheoryPanel>({"Theory", "dock.theory", "The contrast of two intensities under five curves"});
    layout.lessons = docks.add<LessonsPanel>({"Lessons", "dock.lessons", "Lessons on simulated scans, step by step"});
    layout.docks = docks.arrange();
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

    addPanels(layout, window, document, course);

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
