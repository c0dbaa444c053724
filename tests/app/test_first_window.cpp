// The first window fits its screen, whatever that is, and so does one whose remembered size no longer does.
#include <QDockWidget>
#include <QMenuBar>
#include <QScreen>
#include <QStatusBar>

#include "app/window/window_place.h"
#include "tests/app/window_fixture.h"
#include "tests/qt_program/test_classes.h"

using namespace echolucent;

class TestFirstWindow : public QObject {
    Q_OBJECT

private slots:
    void isInsideTheRoomAndAsNearAsCanBe_data() {
        QTest::addColumn<QRect>("room");
        QTest::addColumn<QRect>("wanted");
        QTest::addColumn<QRect>("fits");
        const QRect wanted(QPoint(0, 0), roomySize);
        QTest::newRow("large") << QRect(0, 0, 1920, 1040) << wanted << wanted;
        QTest::newRow("1366x768 with a bar above") << QRect(0, 27, 1366, 741) << wanted << QRect(0, 27, 1366, 741);
        QTest::newRow("1024x768") << QRect(0, 0, 1024, 768) << wanted << QRect(0, 0, 1024, 768);
        QTest::newRow("beyond its edge") << QRect(0, 0, 1920, 1040) << QRect(1500, 900, 800, 600)
                                         << QRect(1120, 440, 800, 600);
        QTest::newRow("on another screen")
            << QRect(1280, 0, 1280, 720) << QRect(-40, -10, 900, 900) << QRect(1280, 0, 900, 720);
    }
    void isInsideTheRoomAndAsNearAsCanBe() {
        QFETCH(QRect, room);
        QFETCH(QRect, wanted);
        QFETCH(QRect, fits);
        QCOMPARE(inside(wanted, room), fits);
    }

    void fitsTheScreen_data() {
        QTest::addColumn<bool>("remembered");
        QTest::newRow("at the first start") << false;
        QTest::newRow("as remembered from a larger screen") << true;
    }
    void fitsTheScreen() {
        QFETCH(bool, remembered);
        const QTemporaryDir folder;
        const QString settings = folder.filePath("settings.ini");
        if (remembered) {
            QWidget larger;
            larger.setGeometry(300, 200, 3000, 2200);
            Settings(settings).setWindowGeometry(larger.saveGeometry());
        }
        MainWindow window(settings);
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        QSignalSpy shown(&window, &MainWindow::shown);
        QTRY_VERIFY(!shown.isEmpty() || window.screen()->availableGeometry().contains(window.frameGeometry()));
        QCoreApplication::processEvents();
        const QRect room = window.screen()->availableGeometry();
        QVERIFY2(
            room.contains(window.frameGeometry()),
            qPrintable(QString("%1 x %2").arg(window.frameGeometry().width()).arg(window.frameGeometry().height())));
        const auto whole = [&window](const QWidget* widget) {
            return window.rect().contains(QRect(widget->mapTo(&window, QPoint(0, 0)), widget->size()));
        };
        QVERIFY(whole(window.menuBar()) && whole(window.statusBar()));
        const auto* dock = window.findChild<QDockWidget*>("dock.view");
        QVERIFY(whole(dock) && whole(window.findChild<QWidget*>("motion")));
        QVERIFY2(window.volumeView().width() >= 0.6 * window.width(),
                 qPrintable(QString::number(window.volumeView().width())));
        QVERIFY(window.volumeView().height() >= 0.6 * window.height());
        // No control of the motion bar is cut.
        const auto* motion = window.findChild<QWidget*>("motion");
        for (const QWidget* control : motion->findChildren<QWidget*>()) {
            if (!control->isVisible() || control->objectName().isEmpty()) continue;
            QVERIFY2(whole(control), qPrintable(control->objectName()));
            QVERIFY2(control->width() >= control->minimumSizeHint().width(), qPrintable(control->objectName()));
        }
        QTRY_VERIFY(window.idle());
    }
};

ECHOLUCENT_TEST_CLASS(TestFirstWindow)

#include "test_first_window.moc"
