#include "app/window/window_faces.h"

#include <QAction>
#include <QActionGroup>
#include <QDockWidget>
#include <QMainWindow>
#include <QMenu>
#include <algorithm>
#include <array>
#include <utility>

#include "widgets/controls/run_status.h"
#include "widgets/panels/motion_panel.h"
#include "widgets/panels/view_panel.h"

namespace echolucent {

namespace {

constexpr std::array reviewDocks{"dock.view", "dock.room", "dock.study"};
/// Of these only the entry in the menu of panels belongs to Teach, and a key or a button opens them in Review too.
constexpr std::array teachDocks{"dock.method",    "dock.tubeCores", "dock.designers", "dock.compare",
                                "dock.motionMap", "dock.explain",   "dock.theory",    "dock.lessons"};

QList<QDockWidget*> docksOf(const QMainWindow& window) {
    return window.findChildren<QDockWidget*>(Qt::FindDirectChildrenOnly);
}

bool isInFront(const QDockWidget* dock) { return dock->isVisible() && !dock->visibleRegion().isEmpty(); }

}  // namespace

WindowFaces::WindowFaces(const Parts& parts, QObject* parent)
    : QObject(parent), m_parts(parts), m_face(parts.settings.face()) {
    createActions();
    listEntries();
}

void WindowFaces::createActions() {
    auto* menu = m_parts.window.findChild<QMenu*>(QStringLiteral("menu.view"));
    auto* group = new QActionGroup(this);
    const auto add = [&](Face face, const QString& text, const QString& name) {
        auto* action = new QAction(text, menu);
        action->setObjectName(name);
        action->setCheckable(true);
        action->setChecked(face == m_face);
        action->setActionGroup(group);
        connect(action, &QAction::triggered, this, [this, face] { choose(face); });
        connect(this, &WindowFaces::chosen, action, [action, face](Face now) { action->setChecked(face == now); });
        return action;
    };
    QAction* first = menu->actions().front();
    menu->insertAction(first, add(Face::review, tr("Re&view"), QStringLiteral("view.review")));
    menu->insertAction(first, add(Face::teach, tr("T&each"), QStringLiteral("view.teach")));
    menu->insertSeparator(first);
}

void WindowFaces::listEntries() {
    const QMainWindow& window = m_parts.window;
    const auto menu = [&window](const char* name) { return window.findChild<QMenu*>(QLatin1String(name)); };
    m_entries.push_back({menu("menu.room"), window.findChild<QAction*>(QStringLiteral("room.tubeCores"))});
    m_entries.push_back({menu("menu.room"), window.findChild<QAction*>(QStringLiteral("room.compare"))});
    m_entries.push_back({menu("menu.room"), menu("menu.compare")->menuAction()});
    m_entries.push_back({menu("menu.motion"), window.findChild<QAction*>(QStringLiteral("motion.showMap"))});
    for (const QDockWidget* dock : docksOf(window))
        if (std::ranges::find(teachDocks, dock->objectName()) != teachDocks.end())
            m_entries.push_back({menu("menu.panels"), dock->toggleViewAction()});
}

void WindowFaces::choose(Face face) {
    if (face == m_face) return;
    QStringList open;
    // A comparison has taken the place of the planes for a while.
    const QLatin1String planes("dock.room"), comparison("dock.compare");
    const bool compares = comparing();
    for (const QDockWidget* dock : docksOf(m_parts.window)) {
        const bool lent = compares && (dock->objectName() == planes || dock->objectName() == comparison);
        if (lent ? dock->objectName() == planes || m_face == Face::teach : !dock->isHidden())
            open << dock->objectName();
    }
    m_open[static_cast<int>(m_face)] = open;
    m_face = face;
    m_parts.settings.setFace(face);
    putOn(true);
    emit chosen(face);
}

void WindowFaces::restore(bool panelsAreRestored) { putOn(!panelsAreRestored); }

void WindowFaces::putOn(bool arrangesPanels) {
    const bool all = m_face == Face::teach;
    m_parts.status.setDetailed(all);
    m_parts.picture.setMoreShown(all);
    m_parts.motion.setOtfsShown(all);
    offerEntries(all);
    // The menu's actions belong to the window too, so their keys work while the menu is out of sight.
    m_parts.window.findChild<QMenu*>(QStringLiteral("menu.otf"))->menuAction()->setVisible(all);
    if (arrangesPanels) arrangePanels();
}

bool WindowFaces::isOffered(const QDockWidget& dock) const {
    const auto remembered = m_open.constFind(static_cast<int>(m_face));
    if (remembered != m_open.constEnd()) return remembered->contains(dock.objectName());
    return m_face == Face::teach || std::ranges::find(reviewDocks, dock.objectName()) != reviewDocks.end();
}

bool WindowFaces::comparing() const {
    return m_parts.window.findChild<QAction*>(QStringLiteral("room.compare"))->isChecked();
}

void WindowFaces::arrangePanels() {
    const QList<QDockWidget*> docks = docksOf(m_parts.window);
    const auto front = std::ranges::find_if(docks, isInFront);
    QDockWidget* inFront = front == docks.end() ? nullptr : *front;
    // What is compared on the screen keeps its panel, and planes that are not seen get none.
    const bool compares = comparing();
    for (QDockWidget* dock : docks) {
        if (compares && dock->objectName() == QLatin1String("dock.compare"))
            dock->show();
        else if (!compares || dock->objectName() != QLatin1String("dock.room"))
            dock->setVisible(isOffered(*dock));
    }
    const bool stays = inFront != nullptr && !inFront->isHidden();
    (stays ? inFront : m_parts.window.findChild<QDockWidget*>(QStringLiteral("dock.view")))->raise();
}

void WindowFaces::offerEntries(bool offered) {
    if (std::exchange(m_entriesAreOffered, offered) == offered) return;
    if (offered) {
        // The one behind an entry may be an entry too, so the last comes back first.
        for (auto entry = m_entries.rbegin(); entry != m_entries.rend(); ++entry)
            entry->menu->insertAction(entry->before, entry->action);
        return;
    }
    for (Entry& entry : m_entries) {
        const QList<QAction*> actions = entry.menu->actions();
        entry.before = actions.value(actions.indexOf(entry.action) + 1);
        entry.menu->removeAction(entry.action);
    }
}

}  // namespace echolucent
