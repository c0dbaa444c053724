#include "app/lesson/lesson_stage.h"

#include <QDockWidget>
#include <QEvent>
#include <QMainWindow>
#include <QScrollArea>
#include <QTimer>
#include <algorithm>
#include <utility>

#include "app/explain/tube_core_choice.h"
#include "widgets/controls/dock_around.h"
#include "widgets/lesson/lessons_panel.h"
#include "widgets/theory/theory_panel.h"

namespace echolucent {

namespace {

constexpr int panelWidth = 300;         // logical pixels; at 1280 the picture keeps 640
constexpr double plainHeight = 600.0;   // of a full screen on which the letters are as large as in the window
constexpr double largestLetters = 2.4;  // times those in the window

}  // namespace

LessonStage::LessonStage(const Parts& parts, QObject* parent)
    : QObject(parent), m_parts(parts), m_outline(parts.window) {}

QDockWidget* LessonStage::dock() const { return dockAround(&m_parts.panel); }

void LessonStage::enter() {
    if (!m_before)
        m_before = Before{m_parts.panes.paneLayout(), m_parts.tubeCore.shown(), m_parts.theory.setting(),
                          dockAround(&m_parts.controls)->width()};
    m_parts.panes.setPaneLayout(PaneLayout::only3d);
    m_parts.tubeCore.setShown(false);
    m_parts.theory.setSetting({});
    standAside();
    if (QDockWidget* controls = dockAround(&m_parts.controls); controls != nullptr && !controls->isHidden())
        controls->raise();
}

void LessonStage::leave() {
    lookAt({});
    standBack();
    const std::optional<Before> before = std::exchange(m_before, std::nullopt);
    if (!before) return;
    m_parts.panes.setPaneLayout(before->layout);
    m_parts.tubeCore.setShown(before->tubeCoresShown);
    m_parts.theory.setSetting(before->theory);
    // The panels are in their places with the next events.
    QTimer::singleShot(0, this, [this, width = before->columnWidth] {
        m_parts.window.resizeDocks({dockAround(&m_parts.controls)}, {width}, Qt::Horizontal);
    });
}

void LessonStage::standAside() {
    QDockWidget* panel = dock();
    if (panel == nullptr) return;
    if (!m_place && !panel->isFloating()) {
        const QList<QDockWidget*> beside = m_parts.window.tabifiedDockWidgets(panel);
        m_place = Place{m_parts.window.dockWidgetArea(panel), panel->isHidden(), beside.value(0)};
        m_parts.window.addDockWidget(Qt::LeftDockWidgetArea, panel);
        setWidth();
    }
    panel->show();
    panel->raise();
}

/// Puts the panel back into its place, and closes the panels that a step has opened.
void LessonStage::standBack() {
    for (const QPointer<QDockWidget>& each : std::exchange(m_opened, {}))
        if (each) each->hide();
    QDockWidget* panel = dock();
    const std::optional<Place> place = std::exchange(m_place, std::nullopt);
    if (panel == nullptr || !place) return;
    if (!panel->isFloating()) {
        m_parts.window.addDockWidget(place->area, panel);
        if (place->beside && !place->beside->isFloating()) m_parts.window.tabifyDockWidget(place->beside, panel);
    }
    panel->setVisible(!place->hidden);
    if (!place->hidden) panel->raise();
}

void LessonStage::setWidth() {
    QDockWidget* panel = dock();
    if (panel == nullptr || !m_place) return;
    m_parts.window.resizeDocks({panel}, {static_cast<int>(panelWidth * m_parts.panel.letters())}, Qt::Horizontal);
}

void LessonStage::setFullScreen(bool full) {
    if (!m_before) full = false;
    if (std::exchange(m_fullScreen, full) == full) return;
    m_lent.clear();  // leaving the full screen has put all into its place
    full ? m_parts.window.installEventFilter(this) : m_parts.window.removeEventFilter(this);
    fitLetters();
    if (!m_before) return;
    if (QDockWidget* panel = dock(); panel != nullptr && full) panel->show();
    // Leaving the full screen shows all bars.
    if (full)
        for (QWidget* bar : m_parts.bars) bar->show();
    lookAt(m_outline.target() ? m_outline.target()->objectName() : QString());
}

void LessonStage::fitLetters() {
    m_parts.panel.setLetters(m_fullScreen ? std::clamp(m_parts.window.height() / plainHeight, 1.0, largestLetters)
                                          : 1.0);
    // The panel has its least width with the next events.
    QTimer::singleShot(0, this, &LessonStage::setWidth);
}

/// What the step before has shown on the full screen goes, if the target does not stand in it too.
void LessonStage::takeLentBut(const QWidget* target) {
    for (const QPointer<QWidget>& each : std::exchange(m_lent, {})) {
        if (!each) continue;
        if (target != nullptr && (each == target || each->isAncestorOf(target)))
            m_lent << each;
        else
            each->hide();
    }
}

void LessonStage::beginStep(const QString& name) {
    m_stepTheory = m_parts.theory.setting();
    lookAt(name);
}

void LessonStage::resetStep() { m_parts.theory.setSetting(m_stepTheory); }

void LessonStage::lookAt(const QString& name) {
    auto* target = name.isEmpty() ? nullptr : m_parts.window.findChild<QWidget*>(name);
    if (m_outline.target() != nullptr) m_outline.target()->removeEventFilter(this);
    takeLentBut(target);
    for (QWidget* around = target; around != nullptr && !around->isWindow(); around = around->parentWidget()) {
        auto* dock = qobject_cast<QDockWidget*>(around);
        if (dock == nullptr) continue;
        if (m_fullScreen && dock->isHidden()) m_lent << dock;
        if (dock->isHidden() && !m_fullScreen) m_opened << dock;
        dock->show();
        dock->raise();
    }
    m_outline.lieAround(target);
    if (target == nullptr) return;
    target->installEventFilter(this);
    scrollToTarget();
}

/// What the step sets, or explains, may make rows and plots above the target, which get their places with the next
/// events.
void LessonStage::scrollToTarget() {
    QTimer::singleShot(0, this, [this] {
        QWidget* target = m_outline.target();
        for (QWidget* around = target; around != nullptr; around = around->parentWidget())
            if (auto* scroll = qobject_cast<QScrollArea*>(around)) scroll->ensureWidgetVisible(target);
    });
}

bool LessonStage::eventFilter(QObject* watched, QEvent* event) {
    // The screen's size may come some time after the window has asked for it.
    if (event->type() == QEvent::Resize && watched == &m_parts.window) fitLetters();
    if (event->type() == QEvent::Show && watched == m_outline.target()) scrollToTarget();
    return QObject::eventFilter(watched, event);
}

}  // namespace echolucent
