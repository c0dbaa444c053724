// The full screen shows the picture alone, and Escape ends what is under way before it.
#include <QDockWidget>
#include <QMenuBar>
#include <QStatusBar>
#include <QWindow>

#include "app/compare/compare_room.h"
#include "app/window/window_faces.h"
#include "tests/app/window_fixture.h"
#include "tests/qt_program/test_classes.h"
#include "widgets/compare/otf_inset.h"
#include "widgets/otf_editor/curve_style.h"
#include "widgets/theme_colours.h"

using namespace echolucent;

class TestMainWindowFullScreen : public QObject, private WindowFixture {
    Q_OBJECT

private slots:
    void initTestCase() {
        lookAtNoPicture();
        seeSides();
        teach();
        m_file = file("still.mha", {smallPhantom(PhantomScene::shapes, 5)});
    }
    void init() {
        show();
        window().resize(1280, 720);
        open(m_file);
    }
    void cleanup() { close(); }

    void theFullScreenShowsThePictureAloneAndBringsAllBack() {
        child<QDockWidget>("dock.study")->raise();
        window().resizeDocks({child<QDockWidget>("dock.study")}, {380}, Qt::Horizontal);
        QTRY_COMPARE(child<QDockWidget>("dock.study")->width(), 380);
        child<QDockWidget>("dock.method")->close();
        const QSize before = window().size();
        const auto seen = [this] {
            QStringList names;
            for (const char* name : {"toolBar", "dock.view", "dock.otfEditor", "dock.method", "dock.study",
                                     "dock.motionMap", "dock.explain", "motion", "study.facts", "adaptive.strength"})
                if (child<QWidget>(name)->isVisible()) names << name;
            if (window().menuBar()->isVisible()) names << "menu";
            if (window().statusBar()->isVisible()) names << "status";
            return names;
        };
        const QStringList seenBefore = seen();
        QVERIFY(seenBefore.contains("study.facts") && !seenBefore.contains("dock.method"));
        for (const Qt::Key leave : {Qt::Key_F, Qt::Key_Escape}) {
            QTest::keyClick(&window(), Qt::Key_F);
            QVERIFY(window().isFullScreen());
            QCOMPARE(seen(), QStringList());
            QTRY_COMPARE(window().volumeView().size(), window().size());
            QTest::keyClick(&window(), leave);
            QVERIFY(!window().isFullScreen());
            window().resize(before);  // a virtual display has no window manager that would do it
            QTRY_COMPARE(seen(), seenBefore);
            QTRY_COMPARE(child<QDockWidget>("dock.study")->width(), 380);
        }
        waitUntilIdle();
    }

    /// In Teach, as each pane of a comparison does, and in a size for the last row.
    void theOtfOfASinglePictureIsSeenOnTheFullScreen() {
        auto* inset = child<OtfInset>("view3d.otf");
        QVERIFY(inset->isHidden());
        QTest::keyClick(&window(), Qt::Key_F);
        QVERIFY(inset->isVisible());
        const QWidget& picture = window().volumeView();
        QTRY_VERIFY(QRect(picture.mapTo(&window(), QPoint()), picture.size()).contains(inset->geometry()));
        QTRY_VERIFY(inset->width() >= std::min(260, picture.width() / 5));
        QTest::keyClick(&window(), Qt::Key_3);  // eq. 1
        const CurveSet& curves = window().document().document().curves;
        QVERIFY(inset->face().otf == Classification(OpacityCurve(curves.linear)));
        QVERIFY(inset->face().frame == curveColor(CurveKind::linear, Theme::dark));
        const QImage painted = inset->grab().toImage();
        int coloured = 0;
        for (int x = 0; x < painted.width(); ++x)
            for (int y = 0; y < painted.height(); ++y) coloured += painted.pixelColor(x, y) == *inset->face().frame;
        QVERIFY(coloured > painted.width());

        window().faces().choose(Face::review);
        QVERIFY(inset->isHidden());
        window().faces().choose(Face::teach);
        QVERIFY(inset->isVisible());
        window().compareRoom().setShown(true);  // its panes have their own
        QVERIFY(inset->isHidden());
        window().compareRoom().setShown(false);
        QTest::keyClick(&window(), Qt::Key_F);
        QVERIFY(inset->isHidden());
        waitUntilIdle();
    }

    /// A comparison that begins or ends there leaves all panels out of sight, and in their places for later.
    void aComparisonBeginsAndEndsOnTheFullScreen() {
        const auto seen = [this] {
            QStringList names;
            for (const QDockWidget* dock : window().findChildren<QDockWidget*>())
                if (!dock->isHidden()) names << dock->objectName();
            names.sort();
            return names;
        };
        const QStringList before = seen();
        QVERIFY(before.contains("dock.room"));
        const auto key = [this](Qt::Key pressed) { QTest::keyClick(&window(), pressed); };
        key(Qt::Key_F);
        key(Qt::Key_F5);
        QVERIFY(window().compareRoom().shown());
        QCOMPARE(seen(), QStringList());
        key(Qt::Key_F);
        QVERIFY(seen().contains("dock.compare") && !seen().contains("dock.room"));
        key(Qt::Key_F5);
        QCOMPARE(seen(), before);
        key(Qt::Key_F5);
        key(Qt::Key_F);
        key(Qt::Key_F5);
        QCOMPARE(seen(), QStringList());
        key(Qt::Key_F);
        QCOMPARE(seen(), before);
        waitUntilIdle();
    }

    void keysWorkOnTheFullScreenAndClosingThereLosesNoPanel() {
        QTest::keyClick(&window(), Qt::Key_F);
        QTest::keyClick(&window(), Qt::Key_3);
        QCOMPARE(window().document().document().panes.at(firstPane).curve, CurveKind::linear);
        QTest::keyClick(&window(), Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(window().document().document().panes.at(firstPane).curve, CurveKind::adaptive);
        window().close();
        MainWindow next(settingsFile());
        next.show();
        QVERIFY(!next.isFullScreen());
        QVERIFY(next.findChild<QDockWidget*>("dock.view")->isVisible());
        QVERIFY(next.menuBar()->isVisible());
    }

    void theLargePointerIsForTheLastRow() {
        QVERIFY(QApplication::overrideCursor() == nullptr);
        QTest::keyClick(&window(), Qt::Key_F);
        QTest::keyClick(&window(), Qt::Key_K);
        QVERIFY(QApplication::overrideCursor() != nullptr);
        const QCursor large = *QApplication::overrideCursor();
        QCOMPARE(large.pixmap().deviceIndependentSize().toSize(), QSize(largePointerSize, largePointerSize));
        const QImage ring = large.pixmap().toImage();
        QCOMPARE(ring.pixelColor(large.hotSpot()), coloursOverPictures().warning);  // the dot is where it points
        QCOMPARE(ring.pixelColor(large.hotSpot() + QPoint(20, 0)).alpha(), 0);      // what it points at is seen
        QTest::keyClick(&window(), Qt::Key_F);
        QVERIFY(QApplication::overrideCursor() != nullptr);
        QTest::keyClick(&window(), Qt::Key_K);
        QVERIFY(QApplication::overrideCursor() == nullptr);
        QTest::keyClick(&window(), Qt::Key_K);
        close();
        QVERIFY(QApplication::overrideCursor() == nullptr);
    }

    void escapeEndsADragBeforeTheFullScreen() {
        QTest::keyClick(&window(), Qt::Key_F);
        const Pose before = window().document().document().scene.pose;
        auto* inner = pictureWindow();
        const QPoint from(inner->width() / 2, inner->height() / 2);
        QTest::mousePress(inner, Qt::LeftButton, {}, from);
        QTest::mouseMove(inner, from + QPoint(60, 0));
        QTRY_VERIFY(window().document().document().scene.pose != before);
        QTest::keyClick(&window().volumeView(), Qt::Key_Escape);
        QCOMPARE(window().document().document().scene.pose, before);
        QVERIFY(window().isFullScreen());
        QTest::mouseRelease(inner, Qt::LeftButton, {}, from);
        int lassos = 1;
        window().escapeOrder().add(EscapeStep::lasso, [&lassos] { return lassos-- > 0; });
        QTest::keyClick(&window().volumeView(), Qt::Key_Escape);
        QCOMPARE(lassos, 0);
        QVERIFY(window().isFullScreen());
        QTest::keyClick(&window().volumeView(), Qt::Key_Escape);
        QVERIFY(!window().isFullScreen());
        waitUntilIdle();
    }

private:
    QString m_file;
};

ECHOLUCENT_TEST_CLASS(TestMainWindowFullScreen)

#include "test_main_window_full_screen.moc"
