// One sentence for the person at the top of the picture, with ways out as buttons. Not modal.
#pragma once

#include <QList>
#include <QString>
#include <QWidget>
#include <functional>

class QHBoxLayout;
class QLabel;
class QToolButton;

namespace echolucent {

enum class MessageKind { info, warning, error };

/// A way out that a message offers.
struct MessageAction {
    QString text;               ///< "Take the frames as slices"
    std::function<void()> run;  ///< called once, after the bar has closed; may be empty
};

/// Objects: message (this), message.text, message.action.0 ..., message.close. Hidden until showMessage. Escape closes
/// it while the focus is inside.
class MessageBar : public QWidget {
    Q_OBJECT

public:
    explicit MessageBar(QWidget* parent = nullptr);

    /// Shows a sentence; replaces what was shown before.
    void showMessage(MessageKind kind, const QString& text, const QList<MessageAction>& actions = {});
    /// A sentence that is true of what is shown now: stands behind the message, or alone as a warning. Empty takes it
    /// away; said again after it was closed, it stays closed.
    void setRemark(const QString& sentence);
    /// Takes the message away where it is still this one; the remark stays. Emits nothing.
    void takeBack(const QString& text);
    /// Closes the bar, the remark included; emits nothing.
    void dismiss();

    /// Message and remark; empty where nothing is shown.
    [[nodiscard]] QString text() const;
    [[nodiscard]] MessageKind kind() const { return m_kind; }

signals:
    /// The person closed the bar, or took an action (then before it runs).
    void closed();

protected:
    void paintEvent(QPaintEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    void removeActions();
    void showText();
    void closeByPerson();

    MessageKind m_kind = MessageKind::info;         ///< as it is shown: a remark makes a warning of an information
    MessageKind m_messageKind = MessageKind::info;  ///< the message's own
    QString m_message;
    QString m_remark;
    bool m_remarkClosed = false;
    QLabel* m_text;
    QHBoxLayout* m_actions;
    QToolButton* m_close;
};

}  // namespace echolucent
