// One drag, one burst of the wheel, one held key: one gesture each.
#include <QKeyEvent>
#include <QSlider>
#include <QTest>
#include <QWheelEvent>

#include "tests/qt_program/test_classes.h"
#include "widgets/hand_gesture.h"

using namespace echolucent;

class TestHandGesture : public QObject {
    Q_OBJECT

private slots:
    void init() {
        m_slider = std::make_unique<QSlider>(Qt::Horizontal);
        m_slider->resize(300, 30);
        m_slider->setRange(0, 1000);
        m_slider->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_slider.get()));
        m_slider->setFocus();
        m_gesture = std::make_unique<HandGesture>(nullptr, 1'000'000);
        m_gestures.clear();
        connect(m_slider.get(), &QSlider::valueChanged, this, [this] { m_gestures.push_back(m_gesture->current()); });
    }

    void withoutAHandThereIsNone() {
        m_slider->setValue(5);
        m_slider->setValue(6);
        QCOMPARE(m_gestures, (std::vector<int>{0, 0}));
    }

    void aDragIsOne() {
        const auto drag = [this](int from, int to) {
            QTest::mousePress(m_slider.get(), Qt::LeftButton, {}, {from, 15});
            for (int x = from; x <= to; x += 10) QTest::mouseMove(m_slider.get(), {x, 15});
            m_slider->setValue(m_slider->value() + 1);  // as by the movement
            m_slider->setValue(m_slider->value() + 1);
            QTest::mouseRelease(m_slider.get(), Qt::LeftButton, {}, {to, 15});
        };
        drag(20, 200);
        QVERIFY(m_gestures.size() >= 2);
        const int first = m_gestures.front();
        QVERIFY(first != 0);
        for (const int gesture : m_gestures) QCOMPARE(gesture, first);
        QCoreApplication::processEvents();
        QCOMPARE(m_gesture->current(), 0);
        m_gestures.clear();
        drag(100, 150);
        QVERIFY(m_gestures.front() != 0);
        QVERIFY(m_gestures.front() != first);
    }

    void aHeldKeyIsOne() {
        const auto send = [this](QEvent::Type type, bool again) {
            QKeyEvent event(type, Qt::Key_Right, {}, {}, again);
            QCoreApplication::sendEvent(m_slider.get(), &event);
        };
        send(QEvent::KeyPress, false);
        for (int i = 0; i < 3; ++i) {
            send(QEvent::KeyRelease, true);
            QCoreApplication::processEvents();
            send(QEvent::KeyPress, true);
        }
        send(QEvent::KeyRelease, false);
        QCoreApplication::processEvents();
        send(QEvent::KeyPress, false);
        send(QEvent::KeyRelease, false);
        QCOMPARE(m_gestures.size(), std::size_t{5});
        for (int i = 1; i < 4; ++i) QCOMPARE(m_gestures[static_cast<std::size_t>(i)], m_gestures[0]);
        QVERIFY(m_gestures[4] != m_gestures[0]);
        QVERIFY(m_gestures[0] != 0);
    }

    void aHeldKeyStaysOneWhenAnotherIsLetGo() {
        const auto send = [this](QEvent::Type type, int key, bool again) {
            QKeyEvent event(type, key, {}, {}, again);
            QCoreApplication::sendEvent(m_slider.get(), &event);
            QCoreApplication::processEvents();
        };
        send(QEvent::KeyPress, Qt::Key_Control, false);
        send(QEvent::KeyPress, Qt::Key_Right, false);
        send(QEvent::KeyRelease, Qt::Key_Control, false);
        m_gestures.clear();
        for (int i = 0; i < 3; ++i) send(QEvent::KeyPress, Qt::Key_Right, true);
        QCOMPARE(m_gestures.size(), std::size_t{3});
        QVERIFY(m_gestures[0] != 0);
        QCOMPARE(m_gestures[1], m_gestures[0]);
        QCOMPARE(m_gestures[2], m_gestures[0]);
    }

    void aBurstOfTheWheelIsOneUntilAnotherGesture() {
        const auto turn = [this] {
            QWheelEvent event({10, 10}, m_slider->mapToGlobal(QPointF(10, 10)), {}, {0, 120}, Qt::NoButton, {},
                              Qt::NoScrollPhase, false);
            QCoreApplication::sendEvent(m_slider.get(), &event);
            QCoreApplication::processEvents();
        };
        turn();
        turn();
        QTest::keyClick(m_slider.get(), Qt::Key_Left);
        turn();
        QCOMPARE(m_gestures.size(), std::size_t{4});
        QCOMPARE(m_gestures[0], m_gestures[1]);
        QVERIFY(m_gestures[0] != 0);
        QVERIFY(m_gestures[2] != m_gestures[1]);
        QVERIFY(m_gestures[3] != m_gestures[2]);
    }

    void aBurstEndsWithItsTime() {
        m_gesture = std::make_unique<HandGesture>(nullptr, 1);
        QWheelEvent event({10, 10}, m_slider->mapToGlobal(QPointF(10, 10)), {}, {0, 120}, Qt::NoButton, {},
                          Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(m_slider.get(), &event);
        QVERIFY(m_gestures.front() != 0);
        QTRY_COMPARE(m_gesture->current(), 0);
    }

private:
    std::unique_ptr<QSlider> m_slider;
    std::unique_ptr<HandGesture> m_gesture;
    std::vector<int> m_gestures;
};

ECHOLUCENT_TEST_CLASS(TestHandGesture)
#include "test_hand_gesture.moc"
