// Which edits belong to one movement of the hand.
#pragma once

#include <QObject>
#include <QTimer>

namespace echolucent {

/// Watches the application's mouse, wheel and keys. One gesture is: a button held, a key held, or one burst of the
/// wheel. Edits at other times belong to no gesture.
class HandGesture : public QObject {
    Q_OBJECT

public:
    /// A turn of the wheel within burstMilliseconds of the turn before continues the burst.
    explicit HandGesture(QObject* parent = nullptr, int burstMilliseconds = 400);

    /// The number of the present gesture, a new one for each; DocumentModel::noGesture if there is none.
    [[nodiscard]] int current() const { return m_open ? m_number : 0; }

    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    enum class Kind { none, button, key, wheel };
    void begin(Kind kind);
    void goOn(Kind kind);
    void end();
    void endSoon();

    QTimer m_burst;  ///< runs while a burst of the wheel may go on
    Kind m_kind = Kind::none;
    int m_number = 0;
    bool m_open = false;
};

}  // namespace echolucent
