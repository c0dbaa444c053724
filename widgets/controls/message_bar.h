// A bar over the picture's edge: one sentence, and buttons for ways out. Not modal.
#pragma once

#include <QList>
#include <QString>
#include <QTimer>
#include <QWidget>
#include <functional>
#include <optional>
#include <vector>

#include "widgets/controls/over_picture.h"

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

/// When a message leaves. Whoever shows one says it.
struct MessageEnd {
    enum class When {
        soon,          ///< after some seconds: good news, and answers that need nothing of a person
        withStudy,     ///< once it is taken back, or another study is shown
        whenTakenBack  ///< once it is taken back
    };
    When when;
    QString topic;  ///< a newer message on this topic takes its place; empty: it has none

    [[nodiscard]] static MessageEnd soon(const QString& topic = {}) { return {When::soon, topic}; }
    [[nodiscard]] static MessageEnd withStudy(const QString& topic) { return {When::withStudy, topic}; }
    [[nodiscard]] static MessageEnd whenTakenBack(const QString& topic) { return {When::whenTakenBack, topic}; }
};

/// Objects: message (this), message.text, message.remark, message.action.0 ..., message.close. Hidden until
/// showMessage() or setRemark(). Escape closes the bar while the focus is inside. Message and remark each have a line
/// with its own sign, so that a warning below good news does not change the sign of the news.
///
/// Trouble stays while it is true. Good news lies over it for some seconds; then the trouble is seen again. While the
/// pointer or the focus is on the bar, the seconds do not count.
class MessageBar : public OverPicture {
    Q_OBJECT

public:
    explicit MessageBar(QWidget* parent = nullptr);

    /// Lays the bar over the lower (or upper) edge of a picture and above native windows in it. The bar is as wide as
    /// its words. It stays between the picture's corners if there is room. The picture is already in the same window,
    /// and outlives the bar.
    void lieOver(QWidget& picture, Qt::Edge edge = Qt::BottomEdge);

    /// Turns a sentence into the words that are shown.
    using Reading = std::function<QString(const QString& sentence)>;
    /// `reading` reads each message and remark that is set later, `ofShown` those on the bar. An empty function leaves
    /// sentences as they are.
    void setReading(Reading reading, Reading ofShown);

    /// Shows a message above those before, and in place of one that was to leave soon or is on the same topic. The
    /// remark stays.
    void showMessage(MessageKind kind, const QString& text, const MessageEnd& end,
                     const QList<MessageAction>& actions = {});
    /// Sets a warning about the present picture. It stands below the message, or alone. An empty sentence removes it. A
    /// remark that a person closed stays closed if it is set again.
    void setRemark(const QString& sentence);
    /// Removes the message on a topic, whichever it is, if there is one. The remark stays.
    void takeBack(const QString& topic);
    /// Another study is shown: removes the messages that end with it.
    void endStudy();
    /// Removes all messages and the remark. Emits nothing.
    void dismiss();

    /// How long a message stays that leaves soon [5 s]. One with ways out stays twice as long.
    static constexpr int confirmationMilliseconds = 5000;
    void setConfirmationMilliseconds(int milliseconds) { m_confirmation = milliseconds; }

    /// Message and remark as they are shown; empty if neither is.
    [[nodiscard]] QString text() const;
    /// The message's kind. If the remark stands alone, a warning.
    [[nodiscard]] MessageKind kind() const;

signals:
    /// A person has closed the bar, by its button or Escape. `topic` is that of the message they saw.
    void putAway(const QString& topic);

protected:
    [[nodiscard]] QRect placeOver(const QRect& picture) const override;
    void paintEvent(QPaintEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    struct Message {
        MessageKind kind = MessageKind::info;
        QString text;
        MessageEnd end;
        QList<MessageAction> actions;
        Reading reading;
    };
    [[nodiscard]] const Message* shown() const { return m_messages.empty() ? nullptr : &m_messages.back(); }
    template <typename Condition>
    void removeIf(Condition condition);
    void showNewest();
    void makeActions();
    void removeActions();
    void showText();
    void countDown();
    [[nodiscard]] bool isHeld() const;
    void closeByPerson();
    [[nodiscard]] bool remarks() const { return !m_remarkClosed && !m_remark.isEmpty(); }
    [[nodiscard]] int widthOfWords() const;

    Qt::Edge m_edge = Qt::BottomEdge;
    std::vector<Message> m_messages;  ///< the newest is shown, and only it may be one that leaves soon
    QTimer m_leaves;                  ///< runs while the shown message is one that leaves soon
    int m_confirmation = confirmationMilliseconds;
    Reading m_reading;        ///< of the next message or remark
    Reading m_remarkReading;  ///< of the remark on the bar
    QString m_remark;
    bool m_remarkClosed = false;
    QLabel* m_text;
    QLabel* m_remarkText;
    QHBoxLayout* m_actions;
    QToolButton* m_close;
};

}  // namespace echolucent
