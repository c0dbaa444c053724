// A button as screen readers find it: whatever they do with it is a click.
#pragma once

#include <QAccessibleWidget>

class QAbstractButton;

namespace echolucent {

/// A button that can be checked is a check box. If one of several buttons is always checked, each is a radio button. Qt
/// toggles such a button without a click, and the parts of the window that wait for clicks would not follow. A button
/// that opens a menu says so. The click comes a moment later: what it opens may wait for an answer.
class ButtonAccess : public QAccessibleWidget {
public:
    explicit ButtonAccess(QAbstractButton& button);

    QAccessible::Role role() const override;
    QString text(QAccessible::Text kind) const override;
    QAccessible::State state() const override;
    QStringList actionNames() const override;
    void doAction(const QString& name) override;
    QStringList keyBindingsForAction(const QString& name) const override;

private:
    QAbstractButton& m_button;
};

}  // namespace echolucent
