#include "widgets/lesson/target_pointing.h"

#include <QApplication>
#include <QDockWidget>
#include <QMouseEvent>
#include <QScrollBar>
#include <QSet>
#include <algorithm>
#include <utility>

#include "widgets/controls/dock_around.h"

namespace echolucent {

namespace {

bool isTarget(const QWidget& widget) {
    const QString name = widget.objectName();
    return !name.isEmpty() && !name.startsWith(QLatin1String("qt_")) && !widget.accessibleName().isEmpty() &&
           name.section('.', 0, 0) != QLatin1String("lessons");
}

/// Whether a click on a widget brings other controls into view.
bool leadsElsewhere(const QWidget* widget) {
    return qobject_cast<const QScrollBar*>(widget) != nullptr ||
           (widget != nullptr && widget->property("dockTab").toBool());
}

QString wordsOf(const QWidget& widget) {
    if (const QDockWidget* dock = dockAround(widget.parentWidget()))
        return TargetPointing::tr("%1 (%2)").arg(widget.accessibleName(), dock->windowTitle());
    return widget.accessibleName();
}

}  // namespace

QList<LessonTarget> lessonTargets(const QWidget& window) {
    QList<LessonTarget> targets;
    QSet<QString> seen;
    for (const QWidget* widget : window.findChildren<QWidget*>()) {
        if (!isTarget(*widget) || seen.contains(widget->objectName())) continue;
        seen.insert(widget->objectName());
        targets << LessonTarget{widget->objectName(), wordsOf(*widget)};
    }
    std::ranges::sort(targets, [](const LessonTarget& one, const LessonTarget& other) {
        return std::pair(one.words.toCaseFolded(), one.name) < std::pair(other.words.toCaseFolded(), other.name);
    });
    return targets;
}

TargetPointing::~TargetPointing() {
    if (active()) QApplication::restoreOverrideCursor();
}

void TargetPointing::begin(QWidget& window) {
    if (active()) return;
    m_window = &window;
    m_isPressed = false;
    QApplication::setOverrideCursor(Qt::CrossCursor);
    qApp->installEventFilter(this);
}

void TargetPointing::end() {
    if (!active()) return;
    m_window = nullptr;
    qApp->removeEventFilter(this);
    QApplication::restoreOverrideCursor();
    emit ended();
}

QString TargetPointing::nameOf(const QWidget* widget) const {
    for (; widget != nullptr; widget = widget->parentWidget()) {
        if (widget->objectName().section('.', 0, 0) == QLatin1String("lessons")) return {};
        if (isTarget(*widget) && m_window->isAncestorOf(widget)) return widget->objectName();
    }
    return {};
}

bool TargetPointing::eventFilter(QObject* watched, QEvent* event) {
    if (!active()) return false;
    const auto widget = [watched, event]() -> QWidget* {
        auto* found = qobject_cast<QWidget*>(watched);
        return found != nullptr ? found
                                : QApplication::widgetAt(static_cast<QMouseEvent*>(event)->globalPosition().toPoint());
    };
    switch (event->type()) {
        case QEvent::MouseButtonPress:
        case QEvent::MouseButtonDblClick:
            if (leadsElsewhere(widget())) return false;
            if (static_cast<QMouseEvent*>(event)->button() != Qt::LeftButton) return true;
            m_pressed = nameOf(widget());
            m_isPressed = true;
            return true;
        case QEvent::MouseButtonRelease: {
            if (!m_isPressed) return false;  // of the press that began it
            const QString name = m_pressed;
            end();
            if (!name.isEmpty()) emit chosen(name);
            return true;
        }
        case QEvent::ContextMenu: return true;
        case QEvent::MouseMove:
            // A widget that takes no mouse hands it to those around it.
            if (!watched->isWidgetType()) emit pointed(nameOf(widget()));
            return false;
        case QEvent::ShortcutOverride:
        case QEvent::KeyPress:
            if (static_cast<QKeyEvent*>(event)->key() != Qt::Key_Escape) return false;
            event->accept();
            if (event->type() == QEvent::KeyPress) end();
            return true;
        case QEvent::WindowDeactivate:
            if (watched == m_window) end();
            return false;
        default: return false;
    }
}

}  // namespace echolucent
