// A bar over the picture's edge: one sentence, and buttons for ways out. Not modal.
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
/// showMessage() or setRemark(). Escape closes the bar while the focus is inside. Message and remark each have a line
/// with its own sign, so that a warning below good news does not change the sign of the news.
class MessageBar : public QWidget {
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

    /// Shows a message in place of the one before. The remark stays.
    void showMessage(MessageKind kind, const QString& text, const QList<MessageAction>& actions = {});
    /// Sets a warning about the present picture. It stands below the message, or alone. An empty sentence removes it. A
    /// remark that a person closed stays closed if it is set again.
    void setRemark(const QString& sentence);
    /// Removes the message if it is still `text`. The remark stays. Emits nothing.
    void takeBack(const QString& text);
    /// Closes the bar, the remark included; emits nothing.
    void dismiss();

    /// Message and remark as they are shown; empty if neither is.
    [[nodiscard]] QString text() const;
    /// The message's kind. If the remark stands alone, a warning.
    [[nodiscard]] MessageKind kind() const;

    bool eventFilter(QObject* watched, QEvent* event) override;

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

    QWidget* m_picture = nullptr;  ///< the bar lies over it
    Qt::Edge m_edge = Qt::BottomEdge;
    MessageKind m_kind = MessageKind::info;
    Reading m_reading;                          ///< of the next message or remark
    Reading m_messageReading, m_remarkReading;  ///< of those on the bar
    QString m_message;
    QString m_remark;
    bool m_remarkClosed = false;
    QLabel* m_text;
    QLabel* m_remarkText;
    QHBoxLayout* m_actions;
    QToolButton* m_close;
};

}  // namespace echolucent
