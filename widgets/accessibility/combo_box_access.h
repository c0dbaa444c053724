// A combo box as screen readers find it: called by its label, with its value and its list.
#pragma once

#include <QAccessibleWidget>

class QComboBox;

namespace echolucent {

/// Its name is its accessible name, else the text of its buddy, and behind it the entry that is chosen: "Colour map:
/// Sepia". The child is the
/// list of entries, and of an editable box also the field. Its actions open the list and close it.
class ComboBoxAccess : public QAccessibleWidget {
public:
    explicit ComboBoxAccess(QComboBox& box);

    QString text(QAccessible::Text kind) const override;
    QAccessible::State state() const override;
    int childCount() const override;
    QAccessibleInterface* child(int place) const override;
    int indexOfChild(const QAccessibleInterface* child) const override;
    QAccessibleInterface* childAt(int x, int y) const override;
    QStringList actionNames() const override;
    void doAction(const QString& name) override;

private:
    QComboBox& m_box;
};

}  // namespace echolucent
