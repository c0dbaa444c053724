// Which edits belong to one movement of the hand.
#pragma once

#include <QObject>
#include <QTimer>

namespace echolucent {

/// Watches the application's mouse, wheel and keys. Every edit while a button is held, within one burst of the wheel or
/// while one key is held belongs to one gesture; between them there is none.
class HandGesture : public QObject {
    Q_OBJECT

public:
    /// A wheel that is turned again within burstMilliseconds goes on with its burst.
    explicit HandGesture(QObject* parent = nullptr, int burstMilliseconds = 400);

    /// A number of its own for each gesture, DocumentModel::noGesture where there is none.
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
