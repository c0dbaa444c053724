// A label with an accessible name as screen readers find it: its name, then what it says.
#pragma once

#include <QAccessibleWidget>

class QLabel;

namespace echolucent {

/// "Frame rate: 20 a second". Qt gives the accessible name alone, and nobody hears the text. A label without such a
/// name says its text.
class LabelAccess : public QAccessibleWidget {
public:
    explicit LabelAccess(QLabel& label);

    QAccessible::Role role() const override;
    QString text(QAccessible::Text kind) const override;
    QList<QPair<QAccessibleInterface*, QAccessible::Relation>> relations(
        QAccessible::Relation match = QAccessible::AllRelations) const override;
    QAccessible::State state() const override;

private:
    QLabel& m_label;
};

}  // namespace echolucent
