#include "app/lesson/lesson_stage.h"

#include <QAbstractButton>
#include <QCoreApplication>
#include <QDockWidget>
#include <QEvent>
#include <QMainWindow>
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
constexpr int lookedAtWidth = 340;      // on the full screen, in letters of the application's size
constexpr double plainHeight = 600.0;   // of a full screen on which the letters are as large as in the window
constexpr double largestLetters = 2.4;  // times those in the window
constexpr double pictureShare = 0.4;    // of the full screen's width, which the panels leave to the picture

}  // namespace

LessonStage::LessonStage(const Parts& parts, QObject* parent)
    : QObject(parent), m_parts(parts), m_outline(parts.window) {}

QDockWidget* LessonStage::dock() const { return dockAround(&m_parts.panel); }

/// The panel beside the picture that the step looks at, if it looks at one.
QDockWidget* LessonStage::lookedAt() const {
    QDockWidget* around = dockAround(m_outline.target());
    return around != nullptr && around != dock() && !around->isFloating() ? around : nullptr;
}

void LessonStage::enter() {
    if (!m_before)
        m_before = Before{m_parts.panes.paneLayout(), m_parts.tubeCore.shown(), m_parts.theory.setting(),
                          m_parts.insets.isChecked(), dockAround(&m_parts.controls)->width()};
    m_parts.panes.setPaneLayout(PaneLayout::only3d);
    m_parts.tubeCore.setShown(false);
    m_parts.theory.setSetting({});
    m_parts.insets.setChecked(true);
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
    m_parts.insets.setChecked(before->insets);
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
        m_sizedFor = 0.0;
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

/// Each panel once for its letters: from then on its width is the person's.
void LessonStage::setWidth() {
    const double letters = m_letters.times();
    const bool changed = std::exchange(m_sizedFor, letters) != letters;
    QDockWidget* const beside = m_fullScreen ? lookedAt() : nullptr;
    QList<QDockWidget*> docks;
    QList<int> widths;
    if (dock() != nullptr && m_place && changed) {
        docks << dock();
        widths << static_cast<int>(panelWidth * letters);
    }
    if (beside != nullptr && (changed || m_sizedBeside != beside)) {
        docks << beside;
        widths << static_cast<int>(lookedAtWidth * letters);
    }
    m_sizedBeside = beside;
    m_parts.window.resizeDocks(docks, widths, Qt::Horizontal);
}

void LessonStage::leaveFullScreen() {
    if (!std::exchange(m_fullScreen, false)) return;
    m_parts.window.removeEventFilter(this);
    m_letters.set(nullptr, 1.0);
    m_lookedAtLetters.set(nullptr, 1.0);
    m_sizedFor = 0.0;
    // The panels need less room at once: they get the widths that they had only if they may be so narrow.
    QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);
}

void LessonStage::fullScreenChanged(bool full) {
    if (!m_before) return;
    m_lent.clear();  // leaving the full screen has put all into its place
    if (!full) leaveFullScreen();
    m_fullScreen = full;
    if (full) {
        m_parts.window.installEventFilter(this);
        if (QDockWidget* panel = dock()) panel->show();
        // Leaving the full screen shows all bars.
        for (QWidget* bar : m_parts.bars) bar->show();
    }
    lookAt(m_outline.target() ? m_outline.target()->objectName() : QString());
}

/// On the full screen both panels have larger letters, as large as the height asks for and the picture's share of the
/// width allows.
void LessonStage::fitLetters() {
    if (!m_fullScreen) return;
    const double wanted = m_parts.window.height() / plainHeight;
    const double room = (1.0 - pictureShare) * m_parts.window.width() / (panelWidth + lookedAtWidth);
    const double letters = std::clamp(std::min(wanted, room), 1.0, largestLetters);
    m_letters.set(dock(), letters);
    m_lookedAtLetters.set(lookedAt(), letters);
    // The panels have their least widths with the next events.
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
    fitLetters();
    m_sight.keep(target);
}

bool LessonStage::eventFilter(QObject* watched, QEvent* event) {
    // The screen's size may come some time after the window has asked for it.
    if (event->type() == QEvent::Resize && watched == &m_parts.window) fitLetters();
    return QObject::eventFilter(watched, event);
}

}  // namespace echolucent
