// Less prominent entries of lists and tables, in any theme.
#pragma once

#include <QStyledItemDelegate>

namespace echolucent {

/// If an entry's data of this role is true, it is written in the theme's secondary colour.
inline constexpr int secondaryRole = Qt::UserRole + 1;

/// The delegate of a view with such entries.
class SecondaryItemDelegate : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;

protected:
    void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override;
};

}  // namespace echolucent
