// What the hand does in the window: it turns the picture about the screen's axes from everywhere, turns the 3D view
// along with planes, and plays by keys after a click.
#include <QCheckBox>
#include <QComboBox>
#include <QMouseEvent>
#include <QPushButton>
#include <QRadioButton>
#include <QSlider>
#include <QSpinBox>
#include <QWindow>
#include <cmath>
#include <numbers>

#include "processing/picture/camera_pose.h"
#include "tests/app/planes/room_fixture.h"
#include "tests/qt_program/test_classes.h"
#include "widgets/key_table.h"

using namespace echolucent;

class TestMainWindowHand : public QObject, private RoomFixture {
    Q_OBJECT

private slots:
    void initTestCase() {
        lookAtNoPicture();
        teach();
        m_file = file("still.mha", {smallPhantom(PhantomScene::shapes, 5)});
    }
    void init() {
        show();
        open(m_file);
    }
    void cleanup() { close(); }

    void aDragTurnsByItsAngleFromEveryDirection() {
        constexpr double angles[][3] = {{0, 0, 0},       {90, 0, 0},      {-135, 0, 0},  {180, 0, 0},
                                        {0, 90, 0},      {0, -90, 0},     {40, 90, 0},   {-70, -90, 25},
                                        {120, 90, -160}, {0, 45, 0},      {30, -20, 50}, {-60, 60, 90},
                                        {75, -89, 3},    {10, 89.9, 0},   {0, 0, 90},    {0, 0, -37},
                                        {150, 10, 180},  {-20, -70, -90}, {5, 1, 1},     {-179, 33, 12}};
        const QPoint centre(pictureWindow()->width() / 2, pictureWindow()->height() / 2);
        for (const auto& [azimuth, elevation, roll] : angles) {
            lookFrom(window(), viewpointOf(document().beam.axis, {azimuth, elevation, roll}));
            const Pose start = document().scene.pose;
            const ViewFrame before = seen();
            for (const QPoint& way : {QPoint(0, -60), QPoint(0, 60), QPoint(60, 0), QPoint(-60, 0)}) {
                dragIn3d(centre, centre + way);
                // A drag over the height of the picture is half a turn. What is in front follows the hand.
                const double angle = 60.0 / pictureWindow()->height() * std::numbers::pi;
                const Vec3 toward = before.right * (way.x() / 60) + before.down * (way.y() / 60);
                const Vec3 still = way.x() ? before.down : before.right;
                QVERIFY2(length(seen().forward - (before.forward * std::cos(angle) + toward * std::sin(angle))) < 1e-9,
                         qPrintable(QString("%1 %2 %3").arg(azimuth).arg(elevation).arg(roll)));
                QVERIFY(length((way.x() ? seen().down : seen().right) - still) < 1e-9);
                QVERIFY(document().scene.pose.offsetMm == start.offsetMm);
                QTest::keyClick(&window(), Qt::Key_Z, Qt::ControlModifier);
                QVERIFY(document().scene.pose == start);
            }
        }
        waitUntilIdle();
    }

    void planesTurnThe3dViewAlongIfAsked() {
        key(Qt::Key_F3);
        PlanePane& c = pane("planes.c");
        QTRY_VERIFY(c.isVisible() && c.scene());
        raise("dock.room");
        c.setFocus();
        const Pose alone = document().scene.pose;
        QTest::keyClick(&c, Qt::Key_Right, Qt::ShiftModifier);
        QVERIFY(document().scene.pose == alone);
        click("room.turnsView");
        QVERIFY(document().scene.planes.turnsView);
        QCOMPARE(window().document().steps().undoText(), "3D view along with planes");
        const Document before = document();
        const ViewFrame view = seen();
        const Vec3 axis = frameOf(PlaneName::a, before.scene.planes, before.beam.axis).forward;
        const int steps = window().document().steps().count();
        // From the right rim to the lower rim: a quarter of a turn of plane A, clockwise.
        PlanePane& a = pane("planes.a");
        const QPointF centre =
            a.mapping().seenAt(referencePointOf(before.scene.planes, window().openStudy().volume()->dataBox()));
        drag(a, QPointF(a.width() - 8, std::round(centre.y())), QPointF(std::round(centre.x()), a.height() - 8));
        QCOMPARE(window().document().steps().count(), steps + 1);
        QCOMPARE(window().document().steps().undoText(), "turn planes");
        QVERIFY(std::abs(seen().forward.dot(axis) - view.forward.dot(axis)) < 1e-9);
        const auto across = [&](const Vec3& vector) { return Vec3(vector - axis * axis.dot(vector)); };
        QVERIFY(length(across(seen().right) + axis.cross(across(view.right))) < 2e-2);  // -90 degrees, whole pixels
        QTest::keyClick(&window(), Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(document() == before);
        // A drag that Escape ends leaves nothing.
        QTest::mousePress(&a, Qt::LeftButton, {}, QPoint(a.width() - 8, a.height() / 2));
        moveTo(a, QPoint(a.width() - 8, a.height() / 2 + 30));
        QVERIFY(document().scene.pose != before.scene.pose);
        QTest::keyClick(&a, Qt::Key_Escape);
        QTest::mouseRelease(&a, Qt::LeftButton, {}, QPoint(a.width() - 8, a.height() / 2 + 30));
        QVERIFY(document() == before);
        // A frame of the motion is what turns along, and the motion starts anew there.
        window().document().showFrame(20, 0);
        const ViewFrame frame = seen();
        QTest::keyClick(&c, Qt::Key_Right, Qt::ShiftModifier);
        QCOMPARE(document().scene.motionAngle, 0.0);
        const Vec3 about = frameOf(PlaneName::c, before.scene.planes, before.beam.axis).forward;
        QVERIFY(std::abs(seen().forward.dot(about) - frame.forward.dot(about)) < 1e-9);
        const Vec3 level = frame.right - about * about.dot(frame.right);
        QVERIFY(std::abs((seen().right - about * about.dot(seen().right)).dot(level) / level.dot(level) -
                         std::cos(std::numbers::pi / 18)) < 1e-9);
        waitUntilIdle();
    }

    void spaceAndArrowsAreTheMotionsAfterAClickOnItsBar() {
        for (const char* name : {"motion.play", "motion.pingPong", "motion.mode.mean", "motion.mode.static"}) {
            child<QSpinBox>("motion.otfPhase")->setFocus();
            click(name);
            if (window().motionPlayer().isPlaying()) click(name);
            playsByKeys(name);
        }
        // A list that was opened and left, as the mouse does it.
        auto* axis = child<QComboBox>("motion.axis");
        QTest::mouseClick(axis, Qt::LeftButton);
        QTRY_VERIFY(QApplication::activePopupWidget());
        QTest::keyClick(QApplication::activePopupWidget(), Qt::Key_Escape);
        QTRY_VERIFY(!QApplication::activePopupWidget());
        playsByKeys("motion.axis");
        auto* slider = child<QSlider>("motion.angle");
        QTest::mouseClick(slider, Qt::LeftButton, {}, QPoint(2, slider->height() / 2));
        QTest::mouseClick(slider, Qt::LeftButton, {}, slider->rect().center());
        playsByKeys("motion.angle");
        // A pane that had the focus gives it to the bar.
        window().volumeView().setFocus();
        click("motion.pingPong");
        QVERIFY(!window().volumeView().hasFocus());
        waitUntilIdle();
    }

    void buttonsTakeTheFocusByTabAndNotByAClick() {
        raise("dock.room");
        auto* lines = child<QCheckBox>("room.linesIn3d");
        window().volumeView().setFocus();
        clickAtItsBox(lines);
        QVERIFY(lines->isChecked());
        QVERIFY(window().volumeView().hasFocus());  // a picture keeps its keys
        // A field takes what was typed, and gives the focus away.
        auto* slab = child<QAbstractSpinBox>("room.slab.thickness");
        slab->setFocus();
        slab->selectAll();
        QTest::keyClicks(slab, "7.5");
        clickAtItsBox(lines);
        QCOMPARE(slab->text(), "7.5 mm");
        QVERIFY(!slab->hasFocus() && !lines->hasFocus());
        QTest::keyClick(focused(), Qt::Key_Space);
        QVERIFY(window().motionPlayer().isPlaying() && !lines->isChecked());
        QTest::keyClick(focused(), Qt::Key_Space);
        QVERIFY(!window().motionPlayer().isPlaying());
        // Tab reaches it, and then Space is its own.
        child("room.quiet")->setFocus();
        QTest::keyClick(focused(), Qt::Key_Tab);
        QVERIFY(lines->hasFocus());
        QTest::keyClick(focused(), Qt::Key_Space);
        QVERIFY(lines->isChecked() && !window().motionPlayer().isPlaying());
        int seenButtons = 0;
        for (const auto* button : window().findChildren<QAbstractButton*>()) {
            if (!button->isVisible() || button->focusPolicy() == Qt::NoFocus) continue;
            ++seenButtons;
            QVERIFY2(button->focusPolicy() == Qt::TabFocus, qPrintable(button->objectName()));
        }
        QVERIFY(seenButtons > 10);
        waitUntilIdle();
    }

private:
    /// A check box is as wide as its panel, and its words are not.
    static void clickAtItsBox(QCheckBox* box) {
        QTest::mouseClick(box, Qt::LeftButton, {}, QPoint(10, box->height() / 2));
    }
    /// Where a key that is pressed now goes.
    QWidget* focused() {
        QWidget* widget = QApplication::focusWidget();
        return widget ? widget : &window();
    }
    [[nodiscard]] ViewFrame seen() {
        return frameOf(viewpointOf(document().beam.axis, shownPose(document()).direction));
    }
    void playsByKeys(const char* clicked) {
        const double angle = window().motionPlayer().angle();
        QTest::keyClick(focused(), Qt::Key_Space);
        QVERIFY2(window().motionPlayer().isPlaying(), clicked);
        QTest::keyClick(focused(), Qt::Key_Space);
        QVERIFY2(!window().motionPlayer().isPlaying(), clicked);
        window().motionPlayer().setAngle(angle);
        QTest::keyClick(focused(), Qt::Key_Right);
        QVERIFY2(window().motionPlayer().angle() == angle + 1, clicked);
        QTest::keyClick(focused(), Qt::Key_Left);
        QVERIFY2(window().motionPlayer().angle() == angle, clicked);
    }

    QString m_file;
};

ECHOLUCENT_TEST_CLASS(TestMainWindowHand)

#include "test_main_window_hand.moc"
