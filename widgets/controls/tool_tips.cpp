#include "widgets/controls/tool_tips.h"

#include <QAbstractItemDelegate>
#include <QAbstractItemView>
#include <QAction>
#include <QApplication>
#include <QHeaderView>
#include <QHelpEvent>
#include <QMenu>
#include <QScreen>
#include <QStyleOptionViewItem>
#include <QTableView>
#include <QTextDocument>
#include <QTextLayout>
#include <QToolTip>
#include <algorithm>

namespace echolucent {

namespace {

constexpr int gap = 4;  // between a control and its tip, logical pixels
constexpr QSize pointer(16, 20);

/// What is explained, and where on the screen it lies.
struct Explained {
    QString text{};
    QRect place{};
    bool atItsSide = false;  ///< what lies below is of the same menu or list
};

/// An entry of a menu has a tip of its own if somebody gave it one: else QAction::toolTip() is the entry's text without
/// the marks of its keys.
QString tipOf(const QAction& action) {
    return action.toolTip() == QAction(action.text()).toolTip() ? QString() : action.toolTip();
}

QString plainText(const QString& text) {
    if (!Qt::mightBeRichText(text)) return text;
    QTextDocument document;
    document.setHtml(text);
    return document.toPlainText();
}

/// Whether an item has no room for all that it shows.
bool isCutOff(const QAbstractItemView& view, const QModelIndex& item) {
    QStyleOptionViewItem option;
    option.initFrom(&view);
    option.widget = &view;
    option.rect = view.visualRect(item);
    option.decorationSize = view.iconSize();
    const auto* table = qobject_cast<const QTableView*>(&view);
    if (table != nullptr && table->wordWrap()) option.features |= QStyleOptionViewItem::WrapText;
    const QSize needed = view.itemDelegateForIndex(item)->sizeHint(option, item);
    return needed.width() > option.rect.width() || needed.height() > option.rect.height();
}

QString tipOf(const QAbstractItemView& view, const QModelIndex& item) {
    const QString tip = item.data(Qt::ToolTipRole).toString();
    const bool repeats = plainText(tip) == item.data(Qt::DisplayRole).toString();
    return repeats && !isCutOff(view, item) ? QString() : tip;
}

Explained explained(QWidget& widget, const QHelpEvent& event) {
    const auto onScreen = [&widget](const QRect& place) {
        return QRect(widget.mapToGlobal(place.topLeft()), place.size());
    };
    if (const auto* menu = qobject_cast<const QMenu*>(&widget)) {
        QAction* action = menu->actionAt(event.pos());
        if (action == nullptr || !menu->toolTipsVisible()) return {};
        const QRect entry = menu->actionGeometry(action);
        return {tipOf(*action), onScreen({0, entry.top(), menu->width(), entry.height()}), true};
    }
    const auto* header = qobject_cast<const QHeaderView*>(widget.parentWidget());
    if (header != nullptr && header->viewport() == &widget && header->orientation() == Qt::Horizontal) {
        const int section = header->logicalIndexAt(event.pos());
        if (section < 0) return {};
        return {header->model()->headerData(section, Qt::Horizontal, Qt::ToolTipRole).toString(),
                onScreen({header->sectionViewportPosition(section), 0, header->sectionSize(section), widget.height()})};
    }
    const auto* view = qobject_cast<const QAbstractItemView*>(widget.parentWidget());
    if (view != nullptr && view->viewport() == &widget) {
        const QModelIndex item = view->indexAt(event.pos());
        if (item.data(Qt::ToolTipRole).toString().isEmpty()) return {};
        const QRect row = view->visualRect(item);
        return {tipOf(*view, item), onScreen({0, row.top(), widget.width(), row.height()}), true};
    }
    return {widget.toolTip(), onScreen(widget.rect())};
}

QPoint cornerOf(const QSize& tip, const Explained& what, const QPoint& pointed, const QRect& screen) {
    QRect place = what.place;
    if (place.height() > highestWithTipBeside) place = QRect(pointed, pointer);
    QPoint corner(place.left(), place.bottom() + gap);
    if (corner.y() + tip.height() > screen.bottom()) corner.setY(place.top() - gap - tip.height());
    if (what.atItsSide) {
        const int right = place.right() + gap, left = place.left() - gap - tip.width();
        if (right + tip.width() <= screen.right())
            corner = {right, place.top()};
        else if (left >= screen.left())
            corner = {left, place.top()};
    }
    const auto within = [](int at, int least, int most) { return std::max(least, std::min(at, most)); };
    return {within(corner.x(), screen.left(), screen.right() - tip.width()),
            within(corner.y(), screen.top(), screen.bottom() - tip.height())};
}

}  // namespace

QString linesOfToolTip(const QString& text, const QFont& font) {
    QStringList lines;
    for (const QString& paragraph : plainText(text).split('\n')) {
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
    if (what.text.isEmpty()) {
        if (what.atItsSide) QToolTip::hideText();
        return what.atItsSide;  // Qt would show what is left out here
    }
    QToolTip::showText(help.globalPos(), linesOfToolTip(what.text, QToolTip::font()), &widget);
    const QScreen* pointed = QGuiApplication::screenAt(help.globalPos());
    const QRect screen = (pointed != nullptr ? pointed : widget.screen())->availableGeometry();
    // Qt would cover the control: it puts tips beside the pointer.
    for (QWidget* tip : QApplication::topLevelWidgets())
        if (tip->inherits("QTipLabel") && tip->isVisible())
            tip->move(cornerOf(tip->size(), what, help.globalPos(), screen));
    return true;
}

}  // namespace echolucent
