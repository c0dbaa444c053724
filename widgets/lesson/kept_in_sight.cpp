#include "widgets/lesson/kept_in_sight.h"

#include <QApplication>
#include <QEvent>
#include <QScrollBar>
#include <algorithm>
#include <utility>

namespace echolucent {

KeptInSight::KeptInSight(QObject* parent) : QObject(parent) {
    connect(qApp, &QApplication::focusChanged, this, [this](const QWidget*, const QWidget* now) {
        if (m_area && m_area->widget() != nullptr && m_area->widget()->isAncestorOf(now)) leave();
    });
}

void KeptInSight::keep(QWidget* widget) {
    leave();
    for (QWidget* each = widget; each != nullptr && !m_area; each = each->parentWidget()) {
        auto* area = each != widget ? qobject_cast<QScrollArea*>(each) : nullptr;
        if (area != nullptr && area->widget() != nullptr && area->widget()->isAncestorOf(widget)) m_area = area;
    }
    if (!m_area) return;
    m_widget = widget;
    for (QWidget* each = widget; each != m_area; each = each->parentWidget()) {
        each->installEventFilter(this);
        m_watched << each;
    }
    connect(m_area->verticalScrollBar(), &QScrollBar::actionTriggered, this, &KeptInSight::leave);
    scrollSoon();
}

void KeptInSight::leave() {
    for (const QPointer<QWidget>& each : std::exchange(m_watched, {}))
        if (each) each->removeEventFilter(this);
    if (m_area) disconnect(m_area->verticalScrollBar(), nullptr, this, nullptr);
    m_widget.clear();
    m_area.clear();
}

/// All get their places with the next events.
void KeptInSight::scrollSoon() {
    if (std::exchange(m_soon, true)) return;
    QMetaObject::invokeMethod(this, &KeptInSight::scroll, Qt::QueuedConnection);
}

void KeptInSight::scroll() {
    m_soon = false;
    if (!m_widget || !m_area || m_area->widget() == nullptr || !m_widget->isVisible()) return;
    constexpr int widestRim = 8;  // pixels
    const QRect place(m_widget->mapTo(m_area->widget(), QPoint(0, 0)), m_widget->size());
    QScrollBar* bar = m_area->verticalScrollBar();
    const int seen = m_area->viewport()->height();
    const int rim = place.height() > seen ? widestRim : std::min((seen - place.height()) / 2, widestRim);
    const QRect wanted = place.adjusted(0, -rim, 0, rim);
    if (wanted.top() < bar->value() || wanted.height() > seen)
        bar->setValue(wanted.top());
    else if (wanted.bottom() >= bar->value() + seen)
        bar->setValue(wanted.bottom() + 1 - seen);
}

bool KeptInSight::eventFilter(QObject* watched, QEvent* event) {
    // To scroll moves the panel.
    const bool moved = event->type() == QEvent::Move && (!m_area || watched != m_area->widget());
    if (moved || event->type() == QEvent::Resize || event->type() == QEvent::Show) scrollSoon();
    return QObject::eventFilter(watched, event);
}

}  // namespace echolucent
