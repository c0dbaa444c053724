#include "widgets/lesson/lesson_outline.h"

#include <QEvent>
#include <QPainter>
#include <QWindow>

#include "widgets/theme_colours.h"

namespace echolucent {

namespace {

class OutlineStrip : public QWidget {
public:
    explicit OutlineStrip(QWidget* parent) : QWidget(parent) {
        setAttribute(Qt::WA_DontCreateNativeAncestors);
        setAttribute(Qt::WA_NativeWindow);
        setAttribute(Qt::WA_TransparentForMouseEvents);
        setFocusPolicy(Qt::NoFocus);
    }

protected:
    void paintEvent(QPaintEvent*) override { QPainter(this).fillRect(rect(), coloursOf(palette()).warning); }
};

}  // namespace

LessonOutline::LessonOutline(QWidget& window) : QObject(&window), m_window(window) {
    for (std::size_t side = 0; side < m_strips.size(); ++side) {
        m_strips[side] = new OutlineStrip(&window);
        m_strips[side]->setObjectName(QStringLiteral("lessons.outline.%1").arg(side));
        m_strips[side]->hide();
    }
}

LessonOutline::~LessonOutline() {
    follow(false);
    for (const auto& strip : m_strips) delete strip.data();
}

void LessonOutline::lieAround(QWidget* target) {
    follow(false);
    m_target = target;
    follow(true);
    place();
}

/// Listens to the target and all that it stands in.
void LessonOutline::follow(bool watches) {
    for (QWidget* each = m_target; each != nullptr && each != &m_window; each = each->parentWidget())
        watches ? each->installEventFilter(this) : each->removeEventFilter(this);
    watches&& m_target ? m_window.installEventFilter(this) : m_window.removeEventFilter(this);
}

bool LessonOutline::eventFilter(QObject* watched, QEvent* event) {
    switch (event->type()) {
        case QEvent::Resize:
        case QEvent::Move:
        case QEvent::Show:
        case QEvent::Hide:
        case QEvent::ZOrderChange:
        case QEvent::LayoutRequest:
        case QEvent::ParentChange:
            // The layout may not be done, and a native window that comes to the front must be followed by the frame's.
            QMetaObject::invokeMethod(this, &LessonOutline::place, Qt::QueuedConnection);
            break;
        default: break;
    }
    return QObject::eventFilter(watched, event);
}

QRect LessonOutline::rectangle() const {
    if (m_target == nullptr || !m_target->isVisible()) return {};
    const auto seenOf = [this](QRect place) {
        place.translate(m_target->mapTo(&m_window, QPoint(0, 0)));
        for (const QWidget* around = m_target->parentWidget(); around != nullptr && around != &m_window;
             around = around->parentWidget())
            place &= QRect(around->mapTo(&m_window, QPoint(0, 0)), around->size());
        return place & m_window.rect();
    };
    const QRect target = m_target->rect();
    // A text has no rim in which the frame could lie.
    return seenOf(target).isEmpty() ? QRect() : seenOf(target.adjusted(-width, -width, width, width));
}

void LessonOutline::place() {
    const QRect around = rectangle();
    const std::array<QRect, 4> places{QRect(around.left(), around.top(), around.width(), width),
                                      QRect(around.left(), around.bottom() + 1 - width, around.width(), width),
                                      QRect(around.left(), around.top(), width, around.height()),
                                      QRect(around.right() + 1 - width, around.top(), width, around.height())};
    for (std::size_t side = 0; side < m_strips.size(); ++side) {
        QWidget* strip = m_strips[side];
        if (strip == nullptr) continue;
        strip->setVisible(!around.isEmpty());
        if (around.isEmpty()) continue;
        strip->setGeometry(places[side]);
        strip->raise();
        if (QWindow* own = strip->windowHandle()) own->raise();
    }
}

}  // namespace echolucent
