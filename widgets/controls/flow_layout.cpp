#include "widgets/controls/flow_layout.h"

#include <algorithm>
#include <utility>

namespace echolucent {

namespace {
bool takesRoom(const QLayoutItem& item) { return item.expandingDirections().testFlag(Qt::Horizontal); }
}  // namespace

FlowLayout::FlowLayout(int spacing, QWidget* parent) : QLayout(parent) {
    setSpacing(spacing);
    setContentsMargins(0, 0, 0, 0);
}

FlowLayout::~FlowLayout() {
    for (QLayoutItem* item : m_items) delete item;
}

QLayoutItem* FlowLayout::itemAt(int index) const {
    return index >= 0 && index < count() ? m_items[static_cast<std::size_t>(index)] : nullptr;
}

QLayoutItem* FlowLayout::takeAt(int index) {
    QLayoutItem* item = itemAt(index);
    if (item != nullptr) m_items.erase(m_items.begin() + index);
    return item;
}

QSize FlowLayout::sizeHint() const {
    QSize size;
    for (const QLayoutItem* item : m_items) {
        if (item->isEmpty()) continue;
        const QSize hint = item->sizeHint();
        size = {size.width() + hint.width() + (size.isEmpty() ? 0 : spacing()), std::max(size.height(), hint.height())};
    }
    return size;
}

QSize FlowLayout::minimumSize() const {
    QSize size;
    for (const QLayoutItem* item : m_items)
        if (!item->isEmpty()) size = size.expandedTo(item->sizeHint());
    return size;
}

void FlowLayout::setGeometry(const QRect& rect) {
    QLayout::setGeometry(rect);
    arrange(rect, true);
}

std::vector<FlowLayout::Line> FlowLayout::lines(int width) const {
    std::vector<Line> lines;
    for (int first = 0; first < count(); first = lines.back().end) {
        Line line{first, first};
        for (; line.end < count(); ++line.end) {
            const QLayoutItem* item = itemAt(line.end);
            if (item->isEmpty()) continue;
            const int wider = line.width + (line.width > 0 ? spacing() : 0) + item->sizeHint().width();
            if (line.width > 0 && wider > width) break;
            line.width = wider;
            line.height = std::max(line.height, item->sizeHint().height());
            line.wide += takesRoom(*item) ? 1 : 0;
        }
        lines.push_back(line);
    }
    return lines;
}

int FlowLayout::rows(int width) const {
    return static_cast<int>(std::ranges::count_if(lines(width), [](const Line& line) { return line.width > 0; }));
}

int FlowLayout::arrange(const QRect& rect, bool apply) const {
    int top = rect.top();
    for (const Line& line : lines(rect.width())) {
        int left = rect.left(), spare = std::max(0, rect.width() - line.width), wide = line.wide;
        for (int i = line.first; apply && i < line.end; ++i) {
            QLayoutItem* item = itemAt(i);
            if (item->isEmpty()) continue;
            if (i == m_stretchBefore && i > line.first) left += std::exchange(spare, 0);
            const int more = takesRoom(*item) ? spare / wide-- : 0;
            spare -= more;
            item->setGeometry({left, top, item->sizeHint().width() + more, line.height});
            left += item->sizeHint().width() + more + spacing();
        }
        top += line.height + (line.end < count() ? spacing() / 2 : 0);
    }
    return top - rect.top();
}

}  // namespace echolucent
