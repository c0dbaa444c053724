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

int FlowLayout::arrange(const QRect& rect, bool apply) const {
    const int count = this->count();
    int top = rect.top();
    for (int first = 0; first < count;) {
        int width = 0, height = 0, end = first, wide = 0;
        for (; end < count; ++end) {
            const QLayoutItem* item = itemAt(end);
            if (item->isEmpty()) continue;
            const int wider = width + (width > 0 ? spacing() : 0) + item->sizeHint().width();
            if (width > 0 && wider > rect.width()) break;
            width = wider;
            height = std::max(height, item->sizeHint().height());
            wide += takesRoom(*item) ? 1 : 0;
        }
        int left = rect.left(), spare = std::max(0, rect.width() - width);
        for (int i = first; apply && i < end; ++i) {
            QLayoutItem* item = itemAt(i);
            if (item->isEmpty()) continue;
            if (i == m_stretchBefore && i > first) left += std::exchange(spare, 0);
            const int more = takesRoom(*item) ? spare / wide-- : 0;
            spare -= more;
            item->setGeometry({left, top, item->sizeHint().width() + more, height});
            left += item->sizeHint().width() + more + spacing();
        }
        top += height + (end < count ? spacing() / 2 : 0);
        first = end;
    }
    return top - rect.top();
}

}  // namespace echolucent
