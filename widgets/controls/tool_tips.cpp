#include "widgets/controls/tool_tips.h"

#include <QAbstractItemView>
#include <QAction>
#include <QApplication>
#include <QHelpEvent>
#include <QMenu>
#include <QScreen>
#include <QTextDocument>
#include <QTextLayout>
#include <QToolTip>
#include <algorithm>

namespace echolucent {

namespace {

constexpr int gap = 4;            // between a control and its tip, logical pixels
constexpr int largeHeight = 160;  // what is higher has its tip at the pointer
constexpr QSize pointer(16, 20);

/// What is explained, and where on the screen it lies.
struct Explained {
    QString text{};
    QRect place{};
    bool inMenu = false;
};

/// An entry of a menu has a tip of its own if somebody gave it one: else QAction::toolTip() is the entry's text.
QString tipOf(const QAction& action) {
    QString text = action.text();
    return action.toolTip() == text.remove('&') ? QString() : action.toolTip();
}

Explained explained(QWidget& widget, const QHelpEvent& event) {
    const auto onScreen = [&widget](const QRect& place) {
        return QRect(widget.mapToGlobal(place.topLeft()), place.size());
    };
    if (const auto* menu = qobject_cast<const QMenu*>(&widget)) {
        QAction* action = menu->actionAt(event.pos());
        if (action == nullptr || !menu->toolTipsVisible()) return {};
        return {tipOf(*action), onScreen(menu->actionGeometry(action)), true};
    }
    const auto* view = qobject_cast<const QAbstractItemView*>(widget.parentWidget());
    if (view != nullptr && view->viewport() == &widget) {
        const QModelIndex item = view->indexAt(event.pos());
        return {item.data(Qt::ToolTipRole).toString(), onScreen(view->visualRect(item))};
    }
    return {widget.toolTip(), onScreen(widget.rect())};
}

QPoint cornerOf(const QSize& tip, const Explained& what, const QPoint& pointed, const QRect& screen) {
    QRect place = what.place;
    if (place.height() > largeHeight) place = QRect(pointed, pointer);
    QPoint corner(place.left(), place.bottom() + gap);
    if (corner.y() + tip.height() > screen.bottom()) corner.setY(place.top() - gap - tip.height());
    if (what.inMenu) {
        corner = {place.right() + gap, place.top()};
        if (corner.x() + tip.width() > screen.right()) corner.setX(place.left() - gap - tip.width());
    }
    const auto within = [](int at, int least, int most) { return std::max(least, std::min(at, most)); };
    return {within(corner.x(), screen.left(), screen.right() - tip.width()),
            within(corner.y(), screen.top(), screen.bottom() - tip.height())};
}

}  // namespace

QString linesOfToolTip(const QString& text, const QFont& font) {
    QString plain = text;
    if (Qt::mightBeRichText(text)) {
        QTextDocument document;
        document.setHtml(text);
        plain = document.toPlainText();
    }
    QStringList lines;
    for (const QString& paragraph : plain.split('\n')) {
        QTextLayout layout(paragraph, font);
        QTextOption wrapping;
        wrapping.setWrapMode(QTextOption::WrapAtWordBoundaryOrAnywhere);
        layout.setTextOption(wrapping);
        layout.beginLayout();
        for (QTextLine line = layout.createLine(); line.isValid(); line = layout.createLine()) {
            line.setLineWidth(widestToolTip);
            lines << paragraph.mid(line.textStart(), line.textLength()).trimmed();
        }
        layout.endLayout();
        if (paragraph.isEmpty()) lines << QString();
    }
    const QString wrapped = lines.join('\n');
    if (!Qt::mightBeRichText(wrapped)) return wrapped;
    return QStringLiteral("<p style='white-space:pre'>%1</p>").arg(wrapped.toHtmlEscaped());
}

ToolTips::ToolTips(QObject* parent) : QObject(parent) { QCoreApplication::instance()->installEventFilter(this); }

bool ToolTips::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() != QEvent::ToolTip || !watched->isWidgetType()) return false;
    auto& widget = static_cast<QWidget&>(*watched);
    const auto& help = static_cast<const QHelpEvent&>(*event);
    const Explained what = explained(widget, help);
    if (what.text.isEmpty()) return false;
    QToolTip::showText(help.globalPos(), linesOfToolTip(what.text, QToolTip::font()), &widget);
    // Qt puts a tip beside the pointer, where it covers what it explains.
    for (QWidget* tip : QApplication::topLevelWidgets())
        if (tip->inherits("QTipLabel") && tip->isVisible())
            tip->move(cornerOf(tip->size(), what, help.globalPos(), widget.screen()->geometry()));
    return true;
}

}  // namespace echolucent
