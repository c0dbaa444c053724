// Entries of lists and tables that stand back behind the others, in whatever theme is worn.
#pragma once

#include <QStyledItemDelegate>

namespace echolucent {

/// An entry whose data of this role is true is written in the theme's secondary colour.
inline constexpr int secondaryRole = Qt::UserRole + 1;

/// The delegate of a view with such entries.
class SecondaryItemDelegate : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;

protected:
    void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override;
};

}  // namespace echolucent
