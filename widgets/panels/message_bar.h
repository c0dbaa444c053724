// One sentence for the person over the picture's lower edge, with ways out as buttons. Not modal.
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

/// Objects: message (this), message.text, message.remark, message.action.0 ..., message.close. Hidden until
/// showMessage. Escape closes it while the focus is inside. Message and remark each have a line with a sign of their
/// own, so that good news stays good news beside trouble.
class MessageBar : public QWidget {
    Q_OBJECT

public:
    explicit MessageBar(QWidget* parent = nullptr);

    /// Lays the bar over the lower (or the upper) edge of a picture that outlives it and stands in the same window
    /// already: as wide as its words, between the picture's corners where these leave room, and above native windows in
    /// it.
    void lieOver(QWidget& picture, Qt::Edge edge = Qt::BottomEdge);

    /// Gives the words for a sentence.
    using Reading = std::function<QString(const QString& sentence)>;
    /// Sets how sentences are shown from here on, and how those that are shown now. Without it they are shown as they
    /// are.
    void setReading(Reading reading, Reading ofShown);

    /// Shows a sentence; replaces what was shown before.
    void showMessage(MessageKind kind, const QString& text, const QList<MessageAction>& actions = {});
    /// A sentence that warns of what is shown now: stands below the message, or alone. Empty takes it away; said again
    /// after it was closed, it stays closed.
    void setRemark(const QString& sentence);
    /// Takes the message away where it is still this one; the remark stays. Emits nothing.
    void takeBack(const QString& text);
    /// Closes the bar, the remark included; emits nothing.
    void dismiss();

    /// Message and remark as they are shown; empty where nothing is.
    [[nodiscard]] QString text() const;
    /// The message's; where the remark stands alone, a warning.
    [[nodiscard]] MessageKind kind() const;

    bool eventFilter(QObject* watched, QEvent* event) override;

signals:
    /// The person closed the bar, or took an action (then before it runs).
    void closed();

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    void removeActions();
    void showText();
    void closeByPerson();
    [[nodiscard]] bool remarks() const { return !m_remarkClosed && !m_remark.isEmpty(); }
    void place();
    [[nodiscard]] int widthOfWords() const;

    QWidget* m_picture = nullptr;  ///< over which the bar lies
    Qt::Edge m_edge = Qt::BottomEdge;
    MessageKind m_kind = MessageKind::info;
    Reading m_reading;                          ///< of what will be shown
    Reading m_messageReading, m_remarkReading;  ///< of what is shown
    QString m_message;
    QString m_remark;
    bool m_remarkClosed = false;
    QLabel* m_text;
    QLabel* m_remarkText;
    QHBoxLayout* m_actions;
    QToolButton* m_close;
};

}  // namespace echolucent
