// A part of a panel that a person opens and closes.
#pragma once

#include <QWidget>

class QToolButton;

namespace echolucent {

/// A button with an arrow, and below it what it opens. Closed at first.
class Disclosure : public QWidget {
    Q_OBJECT

public:
    /// `objectName` is that of the button.
    Disclosure(const QString& objectName, const QString& text, const QString& toolTip, QWidget* content,
               QWidget* parent = nullptr);

    [[nodiscard]] bool isOpen() const;

signals:
    void opened(bool open);

private:
    QToolButton* m_button;
};

}  // namespace echolucent
