#include "app/window/review_room.h"

#include <QAction>
#include <QActionGroup>
#include <QDockWidget>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <algorithm>
#include <vector>

#include "app/window/window_layout.h"
#include "widgets/key_table.h"
#include "widgets/volume_view/lasso_pointer.h"
#include "widgets/volume_view/volume_view_widget.h"

namespace echolucent {

ReviewRoom::ReviewRoom(const Parts& parts, QObject* parent)
    : QObject(parent),
      m_parts(parts),
      m_planes(parts.model, parts.openStudy, parts.works, parts.planes),
      m_controls(parts.model, parts.openStudy, parts.picture, parts.panel),
      m_boxIn3d(parts.model, parts.openStudy, parts.picture),
      m_scalpel({parts.model, parts.picture, m_boxIn3d, parts.panel}),
      m_measuring({parts.model, parts.openStudy, parts.planes, parts.picture, m_boxIn3d, parts.messages}),
      m_measurements({parts.model, parts.openStudy, parts.player, m_measuring, parts.measurements}) {
    connect(&m_parts.panel, &RoomPanel::planesResetRequested, &m_planes, &DocumentPlanes::resetAll);
    connect(&m_planes, &DocumentPlanes::pointed, this, &ReviewRoom::pointed);
    connect(&m_planes, &DocumentPlanes::cameraMoved, &m_parts.player, &MotionPlayer::pause);
    connect(&m_scalpel, &ScalpelHand::nothingToCut, this, &ReviewRoom::nothingToCut);
    // One tool is in the hand at a time.
    connect(&m_scalpel, &ScalpelHand::toolChanged, this, [this] {
        if (m_scalpel.tool() && m_measuring.tool()) m_measuring.setTool(std::nullopt);
    });
    connect(&m_measuring, &MeasuringHand::toolChanged, this, [this] {
        if (m_measuring.tool() && m_scalpel.tool()) m_scalpel.setTool(std::nullopt);
    });
    connect(&m_measuring, &MeasuringHand::measured, this, &ReviewRoom::askForName);
    connect(&m_parts.measurements, &MeasurementsPanel::done, this, [this] {
        std::vector<QWidget*> panes{m_measuredIn, &m_parts.picture};
        panes.insert(panes.end(), m_parts.planes.begin(), m_parts.planes.end());
        const auto shown = std::ranges::find_if(panes, [](const QWidget* pane) { return pane && pane->isVisible(); });
        if (shown != panes.end()) (*shown)->setFocus(Qt::OtherFocusReason);
    });
    for (std::size_t i = 0; i < m_parts.planes.size(); ++i)
        connect(m_parts.planes[i], &PlanePane::maximiseRequested, &m_parts.panes,
                [&panes = m_parts.panes, i] { panes.toggleMaximised(i); });
    connect(&m_parts.picture, &VolumeViewWidget::doubleClicked, &m_parts.panes,
            [&panes = m_parts.panes] { panes.toggleMaximised(paneCount - 1); });
}

/// Brings the panel forward, so that a name can be typed at once. If a person closed the panel, it stays closed.
void ReviewRoom::askForName(QWidget* pane) {
    m_measuredIn = pane;
    if (dockOf(m_parts.measurements).isHidden()) return;
    showDockOf(m_parts.measurements);
    m_parts.measurements.askForName();
}

void ReviewRoom::addTo(EscapeOrder& escapes) {
    escapes.add(EscapeStep::drag, [this] { return m_measuring.cancelDrag() || m_planes.cancelDrag(); });
    escapes.add(EscapeStep::lasso, [this] {
        if (m_parts.picture.lasso().cancelDrawing() || m_measuring.dropMarked()) return true;
        if (m_measuring.tool()) {
            m_measuring.setTool(std::nullopt);
            return true;
        }
        if (!m_scalpel.tool()) return false;
        m_scalpel.setTool(std::nullopt);
        return true;
    });
    escapes.add(EscapeStep::maximisedPane, [this] { return m_parts.panes.endMaximised(); });
}

void ReviewRoom::createMenu(QMainWindow& window) {
    QAction* before = nullptr;
    for (QAction* action : window.menuBar()->actions())
        if (action->menu() && action->menu()->objectName() == QStringLiteral("menu.otf")) before = action;
    auto* menu = new QMenu(tr("&Tools"), &window);
    menu->setObjectName(QStringLiteral("menu.room"));
    window.menuBar()->insertMenu(before, menu);
    auto* layouts = new QMenu(tr("La&yout"), &window);
    layouts->setObjectName(QStringLiteral("menu.layout"));
    window.findChild<QMenu*>(QStringLiteral("menu.view"))
        ->insertMenu(window.findChild<QMenu*>(QStringLiteral("view.menuOfSides"))->menuAction(), layouts);
    addLayouts(*layouts);
    addPlanes(*menu);
    menu->addSeparator();
    addBox(*menu);
    menu->addSeparator();
    addScalpel(*menu);
    menu->addSeparator();
    addMeasuring(*menu);
    // The keys work also while the menu bar is hidden.
    for (QMenu* each : {layouts, menu}) {
        each->setToolTipsVisible(true);
        for (QAction* action : each->actions())
            if (!action->shortcut().isEmpty()) window.addAction(action);
    }
}

void ReviewRoom::addLayouts(QMenu& menu) {
    auto* group = new QActionGroup(&menu);
    const auto add = [&](const QString& text, const QString& name, PaneLayout layout) {
        QAction* action = menu.addAction(text);
        action->setObjectName(name);
        action->setShortcut(keyOf(name));
        action->setCheckable(true);
        action->setActionGroup(group);
        connect(action, &QAction::triggered, &m_parts.panes,
                [&panes = m_parts.panes, layout] { panes.setPaneLayout(layout); });
        const auto show = [&panes = m_parts.panes, action, layout] {
            action->setChecked(panes.paneLayout() == layout && !panes.maximised());
        };
        connect(&m_parts.panes, &PaneGrid::paneLayoutChanged, action, show);
        show();
    };
    add(tr("&3D only"), QStringLiteral("room.only3d"), PaneLayout::only3d);
    add(tr("&Planes A, B, C and 3D"), QStringLiteral("room.quad"), PaneLayout::quad);
    add(tr("3D &large, planes small"), QStringLiteral("room.large3d"), PaneLayout::large3d);
}

void ReviewRoom::addPlanes(QMenu& menu) {
    const auto addSwitch = [&](const QString& text, const QString& name, const QString& what, bool Planes::*member) {
        QAction* action = menu.addAction(text);
        action->setObjectName(name);
        action->setCheckable(true);
        connect(action, &QAction::triggered, this, [this, what, member](bool on) {
            m_parts.model.change(what, [&](Document& next) { next.scene.planes.*member = on; });
        });
        m_parts.model.bind(&DocumentModel::planesChanged, action, [action, member](const Document& document) {
            action->setChecked(document.scene.planes.*member);
        });
    };
    addSwitch(tr("Smoo&th the planes"), QStringLiteral("room.quietPlanes"), tr("smoothing of planes"), &Planes::quiet);
    addSwitch(tr("Show planes in 3&D"), QStringLiteral("room.linesIn3d"), tr("planes in 3D"), &Planes::linesIn3d);
    QAction* reset = menu.addAction(tr("&Reset planes"));
    reset->setObjectName(QStringLiteral("room.resetPlanes"));
    connect(reset, &QAction::triggered, &m_planes, &DocumentPlanes::resetAll);
}

void ReviewRoom::addBox(QMenu& menu) {
    QAction* box = menu.addAction(tr("&Box: show only what lies in it"));
    box->setObjectName(QStringLiteral("room.switchBox"));
    box->setShortcut(keyOf(box->objectName()));
    box->setCheckable(true);
    connect(box, &QAction::triggered, &m_controls, &RoomControls::switchBox);
    m_parts.model.bind(&DocumentModel::boxChanged, box,
                       [box](const Document& document) { box->setChecked(document.scene.box.on); });
}

void ReviewRoom::addScalpel(QMenu& menu) {
    QAction* scalpel = menu.addAction(tr("&Scalpel: take or put away"));
    scalpel->setObjectName(QStringLiteral("room.scalpel"));
    scalpel->setShortcut(keyOf(scalpel->objectName()));
    scalpel->setCheckable(true);
    connect(scalpel, &QAction::triggered, &m_scalpel, &ScalpelHand::toggle);
    connect(&m_scalpel, &ScalpelHand::toolChanged, scalpel,
            [this, scalpel] { scalpel->setChecked(m_scalpel.tool().has_value()); });
    QAction* back = menu.addAction(tr("Remo&ve all strokes"));
    back->setObjectName(QStringLiteral("room.takeAllStrokesBack"));
    back->setShortcut(keyOf(back->objectName()));
    connect(back, &QAction::triggered, &m_scalpel, &ScalpelHand::takeAllBack);
}

void ReviewRoom::addMeasuring(QMenu& menu) {
    const auto addTool = [&](const QString& text, const QString& name, MeasurementKind kind) {
        QAction* action = menu.addAction(text);
        action->setObjectName(name);
        action->setShortcut(keyOf(name));
        action->setCheckable(true);
        const auto show = [this, action, kind] { action->setChecked(m_measuring.tool() == kind); };
        connect(action, &QAction::triggered, this, [this, show, kind] {
            m_measuring.toggle(kind);
            show();
        });
        connect(&m_measuring, &MeasuringHand::toolChanged, action, show);
    };
    addTool(tr("&Measure distance"), QStringLiteral("room.measureDistance"), MeasurementKind::distance);
    addTool(tr("Measure &angle"), QStringLiteral("room.measureAngle"), MeasurementKind::angle);
    QAction* remove = menu.addAction(tr("Remove all m&easurements"));
    remove->setObjectName(QStringLiteral("room.removeAllMeasurements"));
    connect(remove, &QAction::triggered, &m_measurements, &MeasurementControls::removeAll);
}

void ReviewRoom::restore() { m_parts.panes.setPaneLayout(m_parts.settings.paneLayout()); }

void ReviewRoom::keep() { m_parts.settings.setPaneLayout(m_parts.panes.paneLayout()); }

}  // namespace echolucent
