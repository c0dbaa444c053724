#include "widgets/controls/secondary_items.h"

#include "widgets/theme_colours.h"

namespace echolucent {

void SecondaryItemDelegate::initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const {
    QStyledItemDelegate::initStyleOption(option, index);
    if (index.data(secondaryRole).toBool())
        option->palette.setColor(QPalette::Text, coloursOf(option->palette).secondary);
}

}  // namespace echolucent
