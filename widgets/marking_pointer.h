// Offers the left button over a pane first to whoever marks or moves places there.
#pragma once

#include <QObject>
#include <QPointF>
#include <functional>

class QMouseEvent;

namespace echolucent {

/// Watches a widget or a window. Offers each press of the left button without Shift, Ctrl and Alt, and each second
/// press of a double click. All other events pass on, and so does a press that nobody takes. Pixels are logical ones of
/// the watched object.
class MarkingPointer : public QObject {
    Q_OBJECT

public:
    /// The answer to an offered press.
    enum class Take {
        no,     ///< it passes on
        drag,   ///< press, moves and release are taken: pressed, dragged and released follow
        click,  ///< it passes on, but a release at the same place is clicked
    };
    using Offer = std::function<Take(const QPointF& pixel)>;

    /// `offer` is asked at each press. The watched object, and what `offer` refers to, outlive this.
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

    QObject& m_watched;
    Offer m_offer;
    Take m_taken = Take::no;
    QPointF m_pressedAt;
};

}  // namespace echolucent
