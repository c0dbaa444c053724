// Offers the left button over a pane first to whoever marks or moves places there.
#pragma once

#include <QObject>
#include <QPointF>
#include <functional>

class QMouseEvent;

namespace echolucent {

/// Watches a widget or a window. Offers each press of the left button without Shift, Ctrl and Alt, and each second
/// press of a double click, if no other button is held. Take says which events the watched object then does not get; it
/// gets all others. Pixels are logical ones of the watched object.
class MarkingPointer : public QObject {
    Q_OBJECT

public:
    /// The answer to an offered press.
    enum class Take {
        no,     ///< the press passes on
        drag,   ///< press, moves and release are taken, and other buttons meanwhile: pressed, dragged and released
                ///< follow
        click,  ///< the press passes on, unless it is the second of a double click; clicked follows if the release is
                ///< near the press, and moves near the press are taken
        clickAlone,  ///< as click, but the watched object gets the press only if a drag follows, or if it is the
                     ///< second of a double click: a click does nothing there
    };
    using Offer = std::function<Take(const QPointF& pixel)>;

    /// `offer` is asked at each such press. The watched object, and what `offer` refers to, outlive this object.
    MarkingPointer(QObject& watched, Offer offer, QObject* parent = nullptr);

    /// A press is a click if the pointer moves less than this before the release: pixels to the right plus pixels down.
    static constexpr double clickReach = 4.0;

    bool eventFilter(QObject* watched, QEvent* event) override;

signals:
    void pressed(const QPointF& pixel);
    void dragged(const QPointF& pixel);
    void released(const QPointF& pixel);
    void clicked(const QPointF& pixel);
    void hovered(const QPointF& pixel);  ///< no button is held; the event passes on
    void left();

private:
    bool press(const QMouseEvent& event);
    bool move(const QMouseEvent& event);
    bool release(const QMouseEvent& event);
    [[nodiscard]] bool isNearPress(const QPointF& pixel) const;
    void passPressOn();

    QObject& m_watched;
    Offer m_offer;
    Take m_taken = Take::no;
    QPointF m_pressedAt, m_pressedAtGlobal;
    bool m_passesPressOn = false;  ///< while a withheld press is sent
};

}  // namespace echolucent
