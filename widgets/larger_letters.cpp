#include "widgets/larger_letters.h"

#include <QApplication>
#include <QChildEvent>
#include <QLayout>
#include <algorithm>
#include <utility>

namespace echolucent {

double lettersOf(const QWidget& widget) { return widget.font().pointSizeF() / QApplication::font().pointSizeF(); }

int inLettersOf(const QWidget& widget, double length) { return qRound(lettersOf(widget) * length); }

QSize inLettersOf(const QWidget& widget, const QSize& size) { return size * lettersOf(widget); }

void LargerLetters::set(QWidget* place, double times) {
    if (place == nullptr) times = 1.0;
    if (place == m_place && times == m_times) return;
    if (place != m_place || times == 1.0) giveBack();
    m_place = place;
    m_times = times;
    if (times != 1.0) enlarge(*place);
}

void LargerLetters::enlarge(QWidget& widget) {
    std::erase_if(m_kept, [](const Kept& kept) { return kept.widget.isNull(); });
    QWidgetList all = widget.findChildren<QWidget*>();
    all.prepend(&widget);
    // What was never shown takes over the font that is set around it: all are kept first.
    for (QWidget* each : std::as_const(all)) {
        if (std::ranges::any_of(m_kept, [each](const Kept& kept) { return kept.widget == each; })) continue;
        m_kept.push_back({each, each->font()});
        each->installEventFilter(this);
    }
    for (QWidget* each : std::as_const(all)) {
        QFont font = each->font();
        font.setPointSizeF(QApplication::font().pointSizeF() * m_times);
        each->setFont(font);
    }
}

void LargerLetters::giveBack() {
    const std::vector<Kept> before = std::exchange(m_kept, {});
    for (const Kept& kept : before) {
        if (!kept.widget) continue;
        kept.widget->removeEventFilter(this);
        QFont font = kept.font;
        // Names of what is chosen are bold.
        if (font.bold() != kept.widget->font().bold()) font.setBold(kept.widget->font().bold());
        kept.widget->setFont(font);
    }
    // A place that is hidden would keep its least size until it is shown: from the inside to the outside.
    for (auto kept = before.rbegin(); kept != before.rend(); ++kept)
        if (kept->widget && kept->widget->layout() != nullptr) kept->widget->layout()->activate();
}

bool LargerLetters::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::ChildPolished)
        if (auto* child = qobject_cast<QWidget*>(static_cast<QChildEvent*>(event)->child())) enlarge(*child);
    return QObject::eventFilter(watched, event);
}

}  // namespace echolucent
