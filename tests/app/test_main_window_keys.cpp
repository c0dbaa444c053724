// Whose a key is: that of the control with the focus, of the picture, or of the window; and the one table of all keys.
#include <QAction>
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QImage>
#include <QKeySequence>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QRadioButton>
#include <QSlider>
#include <QTableView>
#include <QTableWidget>
#include <QWheelEvent>
#include <QWindow>
#include <cmath>

#include "processing/picture/camera_pose.h"
#include "tests/app/window_fixture.h"
#include "tests/qt_program/test_classes.h"
#include "widgets/key_table.h"
#include "widgets/otf_editor/otf_editor.h"

using namespace echolucent;

class TestMainWindowKeys : public QObject, private WindowFixture {
    Q_OBJECT

private slots:
    void initTestCase() {
        lookAlongAssumedBeam();
        lookAtNoPicture();
        teach();
        m_file = file("still.mha", {smallPhantom(PhantomScene::shapes, 5)});
    }
    void init() {
        show();
        open(m_file);
    }
    void cleanup() { close(); }

    void spaceTogglesTheCheckBoxThatHasTheFocus() {
        auto* box = child<QCheckBox>("motion.pingPong");
        QVERIFY(box->isChecked());
        box->setFocus();
        QTest::keyClick(box, Qt::Key_Space);
        QVERIFY(!box->isChecked());
        QVERIFY(!window().motionPlayer().isPlaying());
        window().volumeView().setFocus();
        QTest::keyClick(&window().volumeView(), Qt::Key_Space);
        QVERIFY(window().motionPlayer().isPlaying());
        QTest::keyClick(&window().volumeView(), Qt::Key_Space);
        QVERIFY(!window().motionPlayer().isPlaying());
        waitUntilIdle();
    }

    void arrowsOfRadioButtonsAndSlidersTurnNoProbe() {
        useLook(lookAtStart());      // a lit picture, whose light has a slider
        window().resize(1280, 720);  // room for all buttons of the motion
        auto* first = child<QRadioButton>("motion.mode.static");
        first->setFocus();
        QTest::keyClick(first, Qt::Key_Right);
        QVERIFY(child<QRadioButton>("motion.mode.eachView")->isChecked());
        QCOMPARE(window().motionPlayer().angle(), 0.0);
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Left);
        QVERIFY(first->isChecked());
        auto* slider = child<QSlider>("view.lightAzimuth");
        slider->setFocus();
        const int before = slider->value();
        QTest::keyClick(slider, Qt::Key_Right);
        QCOMPARE(slider->value(), before + 1);
        QCOMPARE(window().motionPlayer().angle(), 0.0);
        window().volumeView().setFocus();
        QTest::keyClick(&window().volumeView(), Qt::Key_Right);
        QCOMPARE(window().motionPlayer().angle(), 1.0);
        QTest::keyClick(&window().volumeView(), Qt::Key_Left);
        QCOMPARE(window().motionPlayer().angle(), 0.0);
        waitUntilIdle();
    }

    void digitsChooseNoCurveWhereATextOrATableHasTheFocus() {
        QTest::keyClick(&window(), Qt::Key_2);
        QCOMPARE(curve(), CurveKind::manual);
        auto* nodes = child<QTableView>("otfEditor.nodeTable");
        const ManualCurve before = window().document().document().curves.manual;
        child<QWidget>("dock.otfEditor")->raise();
        QTRY_VERIFY(nodes->isVisible());
        nodes->setFocus();
        nodes->setCurrentIndex(nodes->model()->index(1, 1));
        for (const Qt::Key key : {Qt::Key_1, Qt::Key_3, Qt::Key_5}) QTest::keyClick(nodes, key);
        QCOMPARE(curve(), CurveKind::manual);
        QVERIFY(window().document().document().curves.manual == before);
        QVERIFY(nodes->findChild<QLineEdit*>() == nullptr);
        child<QWidget>("dock.study")->raise();
        auto* facts = child<QTableWidget>("study.facts");
        QTRY_VERIFY(facts->isVisible());
        facts->setFocus();
        QTest::keyClick(facts, Qt::Key_3);
        QCOMPARE(curve(), CurveKind::manual);
        child<QWidget>("dock.view")->raise();
        auto* number = child<QWidget>("view.nearCut.value");
        QTRY_VERIFY(number->isVisible());
        number->setFocus();
        QTest::keyClick(number, Qt::Key_3);
        QCOMPARE(curve(), CurveKind::manual);
        // A choice wants no digits.
        auto* mode = child<QComboBox>("view.mode");
        mode->setFocus();
        QTest::keyClick(mode, Qt::Key_4);
        QCOMPARE(curve(), CurveKind::parabolic);
        waitUntilIdle();
    }

    void theTableHoldsTheKeysOfAllActionsAndNoOthers() {
        QStringList inWindow;
        for (const QAction* action : window().findChildren<QAction*>())
            if (!action->shortcut().isEmpty())
                inWindow << action->objectName() + ": " + action->shortcut().toString(QKeySequence::PortableText);
        QStringList inTable;
        for (const KeyRow& row : keyTable())
            for (const KeyOfAction& key : row.actions) inTable << key.action + ": " + key.key;
        inWindow.sort();
        inTable.sort();
        QCOMPARE(inWindow, inTable);
        QStringList keys;
        for (const KeyRow& row : keyTable())
            for (const KeyOfAction& key : row.actions) keys << key.key;
        QCOMPARE(keys.removeDuplicates(), 0);
    }

    void noLetterStandsForTwoEntriesOfAMenu() {
        int seen = 0;
        for (const QMenu* menu : window().menuBar()->findChildren<QMenu*>()) {
            QStringList letters;
            for (const QAction* action : menu->actions()) {
                const QString letter = QKeySequence::mnemonic(action->text()).toString();
                if (!letter.isEmpty()) letters << letter;
            }
            seen += static_cast<int>(letters.size());
            const QString all = letters.join(' ');
            QVERIFY2(letters.removeDuplicates() == 0, qPrintable(menu->title() + ": " + all));
        }
        QVERIFY(seen > 20);
    }

    void arrowsWithCtrlOrbitThePictureThatHasTheFocus() {
        window().volumeView().setFocus();
        const ViewDirection before = document().scene.pose.direction;
        const int steps = window().document().steps().count();
        QTest::keyClick(&window().volumeView(), Qt::Key_Right, Qt::ControlModifier);
        CameraPose expected{.view = viewpointOf(document().beam.axis, before)};
        expected = orbited(expected, 1.0 / degreesPerHeight, 0);
        QVERIFY(std::abs(document().scene.pose.direction.azimuth - expected.view.azimuthDegrees) < 1e-9);
        QVERIFY(std::abs(std::abs(document().scene.pose.direction.azimuth - before.azimuth) - 1.0) < 1e-9);
        QTest::keyClick(&window().volumeView(), Qt::Key_Up, Qt::ControlModifier | Qt::ShiftModifier);
        QVERIFY(std::abs(std::abs(document().scene.pose.direction.elevation - before.elevation) - 10.0) < 1e-9);
        QCOMPARE(window().motionPlayer().angle(), 0.0);
        QCOMPARE(window().document().steps().count(), steps + 2);
        for (int i = 0; i < 2; ++i) QTest::keyClick(&window(), Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(document().scene.pose.direction, before);
        // Elsewhere these keys are not the picture's.
        auto* slider = child<QSlider>("motion.angle");
        slider->setFocus();
        QTest::keyClick(slider, Qt::Key_Right, Qt::ControlModifier);
        QCOMPARE(document().scene.pose.direction, before);
        waitUntilIdle();
    }

    void plusMinusAndShiftWithArrowsZoomAndMove() {
        window().volumeView().setFocus();
        const Pose before = document().scene.pose;
        QTest::keyClick(&window().volumeView(), Qt::Key_Plus);
        QVERIFY(std::abs(document().scene.pose.magnification / before.magnification - 1.15) < 1e-9);
        QTest::keyClick(&window().volumeView(), Qt::Key_Minus);
        QVERIFY(std::abs(document().scene.pose.magnification / before.magnification - 1.0) < 1e-9);
        QTest::keyClick(&window().volumeView(), Qt::Key_Down, Qt::ShiftModifier);
        QVERIFY(length(document().scene.pose.offsetMm - before.offsetMm) > 0.5);
        QCOMPARE(document().scene.pose.direction, before.direction);
        waitUntilIdle();
    }

    void theWheelKeepsThePointUnderTheCursor() {
        const auto seenAt = [this](const QPointF& place) {
            const Camera camera = window().volumeView().settings().camera;
            const QSize size = window().volumeView().size();
            return Vec3(camera.focalPoint + camera.heightMm / size.height() *
                                                (camera.frame.right * (place.x() - size.width() / 2.0) +
                                                 camera.frame.down * (place.y() - size.height() / 2.0)));
        };
        QWindow* inner = pictureWindow();
        const QPointF place(inner->width() * 0.3, inner->height() * 0.7);
        const Vec3 before = seenAt(place);
        const double height = window().volumeView().settings().camera.heightMm;
        for (int i = 0; i < 3; ++i) {
            QWheelEvent turn(place, inner->mapToGlobal(place), {}, {0, 120}, Qt::NoButton, Qt::NoModifier,
                             Qt::NoScrollPhase, false);
            QCoreApplication::sendEvent(inner, &turn);
        }
        QVERIFY(window().volumeView().settings().camera.heightMm < 0.7 * height);
        QVERIFY(length(seenAt(place) - before) < 1e-6);
        QVERIFY(length(seenAt({0, 0}) - before) > 1.0);
        waitUntilIdle();
    }

    void thePictureIsCopied() {
        waitUntilIdle();
        QApplication::clipboard()->clear();
        window().volumeView().setFocus();
        QTest::keyClick(&window().volumeView(), Qt::Key_C, Qt::ControlModifier);
        const QImage copied = QApplication::clipboard()->image().convertToFormat(QImage::Format_RGB888);
        QCOMPARE(copied, window().volumeView().screenImage().convertToFormat(QImage::Format_RGB888));
        QVERIFY(!copied.isNull());
    }

    void oneStepResetsAll() {
        const Document opened = document();
        QTest::keyClick(&window(), Qt::Key_3);
        QTest::keyClick(&window(), Qt::Key_L);
        window().volumeView().setFocus();
        QTest::keyClick(&window().volumeView(), Qt::Key_Left, Qt::ControlModifier | Qt::ShiftModifier);
        QTest::keyClick(&window().volumeView(), Qt::Key_Plus);
        Document next = document();
        next.scene.front.depthMm = 12;
        next.curves.linear.slope = 0.3;
        window().document().edit(next, "changes");
        const int steps = window().document().steps().count();
        QTest::keyClick(&window(), Qt::Key_R, Qt::ShiftModifier);
        QVERIFY(document() == opened);
        QCOMPARE(window().document().steps().count(), steps + 1);
        QTest::keyClick(&window(), Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(document() == next);
        click("view.resetAll");
        QVERIFY(document() == opened);
        waitUntilIdle();
    }

    void aCurveOfAnotherViewIsSaid() {
        const auto said = [this] { return window().volumeView().caption().contains("curve of another view"); };
        QVERIFY(!said());
        window().volumeView().setFocus();
        QTest::keyClick(&window().volumeView(), Qt::Key_Right, Qt::ControlModifier | Qt::ShiftModifier);
        QVERIFY(said());
        QVERIFY(window().explanation().contains("computed for another view"));
        QTest::keyClick(&window(), Qt::Key_3);
        QVERIFY(!said());  // a curve that nothing was computed for
        QTest::keyClick(&window(), Qt::Key_1);
        QVERIFY(said());
        QTest::keyClick(&window(), Qt::Key_A);
        waitUntilIdle();
        QVERIFY(!said());
        QTest::keyClick(&window(), Qt::Key_Right);  // a frame of a motion with one OTF
        QVERIFY(!said());
        waitUntilIdle();
    }

private:
    [[nodiscard]] const Document& document() { return window().document().document(); }
    [[nodiscard]] CurveKind curve() { return document().panes.at(firstPane).curve; }

    QString m_file;
};

ECHOLUCENT_TEST_CLASS(TestMainWindowKeys)

#include "test_main_window_keys.moc"
