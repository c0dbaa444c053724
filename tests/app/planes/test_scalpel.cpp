// The scalpel in the real main window: strokes drawn by the mouse, taken back by keys and the panel.
#include <QDoubleSpinBox>
#include <QListWidget>
#include <QToolButton>

#include "tests/app/planes/room_fixture.h"
#include "tests/qt_program/test_classes.h"
#include "widgets/controls/message_bar.h"
#include "widgets/volume_view/lasso_pointer.h"

using namespace echolucent;

class TestScalpel : public QObject, private RoomFixture {
    Q_OBJECT

private slots:
    void initTestCase() {
        QLocale::setDefault(QLocale::c());
        m_file = file("shapes.mha", {smallPhantom(PhantomScene::shapes, 5)});
    }
    void init() {
        show();
        window().resize(1280, 720);
        useLook(Look{});  // light plays no part here, and takes its time
        open(m_file);
        key(Qt::Key_F3);
        QTRY_VERIFY(window().idle());
    }
    void cleanup() { close(); }

    void strokesOfEveryToolAreDrawnAndTakenBack() {
        key(Qt::Key_F2);
        waitUntilIdle();
        const QSize size = window().volumeView().size();
        const QPoint centre(size.width() / 2, size.height() / 2);
        const Pose pose = document().scene.pose;
        key(Qt::Key_S);
        QVERIFY(child<QToolButton>("room.scalpel.freehand")->isChecked());
        QTest::mousePress(pictureWindow(), Qt::LeftButton, {}, centre);
        for (const QPoint& way : {QPoint(40, 0), QPoint(40, 40), QPoint(0, 40)}) moveIn3d(centre + way);
        QTest::mouseRelease(pictureWindow(), Qt::LeftButton, {}, centre + QPoint(0, 40));
        QCOMPARE(strokes().size(), 1u);
        QCOMPARE(strokes()[0].places.size(), 4u);
        QVERIFY(!strokes()[0].depthMm);
        QVERIFY(document().scene.pose == pose);
        raise("dock.room");
        click("room.scalpel.box");
        click("room.scalpel.outside");
        dragIn3d(centre - QPoint(90, 80), centre + QPoint(90, 80));
        QCOMPARE(strokes().size(), 2u);
        QCOMPARE(strokes()[1].side, ScalpelSide::outside);
        click("room.scalpel.eraser");
        dragIn3d(centre - QPoint(60, 60), centre - QPoint(20, 60));
        QCOMPARE(strokes()[2].side, ScalpelSide::inside);
        const double heightMm = strokes()[2].camera.heightMm;
        QVERIFY(std::abs(strokes()[2].radius * heightMm * 2 - child<QDoubleSpinBox>("room.scalpel.size")->value()) <
                1e-9);
        click("room.scalpel.polygon");
        for (const QPoint& corner : {QPoint(-30, -30), QPoint(30, -30), QPoint(0, 30)})
            QTest::mouseClick(pictureWindow(), Qt::LeftButton, {}, centre + corner);
        QTest::keyClick(&window().volumeView(), Qt::Key_Return);
        QCOMPARE(strokes().size(), 4u);
        QCOMPARE(strokes()[3].places.size(), 3u);
        QCOMPARE(child<QListWidget>("room.scalpel.strokes")->count(), 4);
        child<QListWidget>("room.scalpel.strokes")->setCurrentRow(1);
        click("room.scalpel.takeBack");
        QCOMPARE(strokes().size(), 3u);
        QTest::keyClick(&window(), Qt::Key_S, Qt::ShiftModifier);
        QVERIFY(strokes().empty());
        window().document().steps().undo();
        QCOMPARE(strokes().size(), 3u);
        waitUntilIdle();
    }

    void aStrokeDownToADepthCountsFromWhatShows() {
        key(Qt::Key_F2);
        raise("dock.room");
        click("room.scalpel.limited");
        click("room.scalpel.box");
        waitUntilIdle();
        const QSize size = window().volumeView().size();
        const QPoint centre(size.width() / 2, size.height() / 2);
        dragIn3d(centre - QPoint(60, 60), centre + QPoint(60, 60));
        QCOMPARE(strokes().size(), 1u);
        const auto shown = window().volumeView().shownAt({0, 0});
        QVERIFY(shown.has_value());
        const double behind = *strokes()[0].depthMm - strokes()[0].camera.frame.forward.dot(*shown);
        const double limit = child<QDoubleSpinBox>("room.scalpel.limit")->value();
        // What shows in the middle may lie behind the nearest that shows, by no more than the volume is deep.
        QVERIFY(behind <= limit + 2.0);
        QVERIFY(behind > limit - length(dataBox().sizeMm()));
        // Beside the data nothing shows from which a depth could be counted, and the window says so.
        auto* message = child<MessageBar>("message");
        QVERIFY(!message->text().contains("Nothing shows where you drew"));
        dragIn3d({4, centre.y()}, {24, centre.y() + 20});
        QCOMPARE(strokes().size(), 1u);
        QVERIFY2(message->text().contains("Nothing shows where you drew"), qPrintable(message->text()));
        window().document().steps().undo();
        QVERIFY(!message->text().contains("Nothing shows where you drew"));
    }

    void escapeDropsAStrokeThenTheScalpelThenTheRoom() {
        doubleClick(pane("planes.a"));
        QVERIFY(!window().volumeView().isVisible());
        key(Qt::Key_Escape);
        QVERIFY(window().volumeView().isVisible());
        QTest::mouseDClick(pictureWindow(), Qt::LeftButton);
        key(Qt::Key_S);
        QTest::mousePress(pictureWindow(), Qt::LeftButton, {}, QPoint(200, 200));
        moveIn3d(QPoint(260, 200));
        moveIn3d(QPoint(260, 260));
        QTest::keyClick(&window().volumeView(), Qt::Key_Escape);
        QVERIFY(!window().volumeView().lasso().drawing());
        QTest::mouseRelease(pictureWindow(), Qt::LeftButton, {}, QPoint(260, 260));
        QVERIFY(strokes().empty());
        QVERIFY(window().volumeView().lasso().tool().has_value());
        QTest::keyClick(&window().volumeView(), Qt::Key_Escape);
        QVERIFY(!window().volumeView().lasso().tool());
        QVERIFY(!pane("planes.a").isVisible());
        QTest::keyClick(&window().volumeView(), Qt::Key_Escape);
        QVERIFY(pane("planes.a").isVisible());
    }

    void aStrokeIsSeenInThePlanesToo() {
        PlanePane& c = pane("planes.c");
        QTRY_VERIFY(window().idle());
        const QPoint middle = c.image().rect().center();
        const auto darkPixels = [&] {
            int dark = 0;
            for (int y = -20; y <= 20; ++y)
                for (int x = -20; x <= 20; ++x) dark += qGray(c.image().pixel(middle + QPoint(x, y))) == 0;
            return dark;
        };
        const int before = darkPixels();
        raise("dock.room");
        click("room.scalpel.box");
        const QSize size = window().volumeView().size();
        dragIn3d(QPoint(size.width() / 4, size.height() / 4), QPoint(size.width() * 3 / 4, size.height() * 3 / 4));
        QTRY_VERIFY(window().idle());
        QTRY_VERIFY(darkPixels() > before + 1000);
        window().document().steps().undo();
        QTRY_COMPARE(darkPixels(), before);
    }

private:
    QString m_file;
};

ECHOLUCENT_TEST_CLASS(TestScalpel)
#include "test_scalpel.moc"
