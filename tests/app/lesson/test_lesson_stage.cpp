// What a lesson does with the window: where its words stand, what it outlines, and what it gives back.
#include <QAction>
#include <QDockWidget>
#include <QLabel>

#include "app/compare/compare_room.h"
#include "app/explain/tube_core_choice.h"
#include "app/lesson/lesson_player.h"
#include "app/sessions/session_keeping.h"
#include "app/window/window_faces.h"
#include "tests/app/lesson/lesson_fixture.h"
#include "widgets/planes/pane_grid.h"
#include "widgets/theory/theory_panel.h"

using namespace echolucent;

class TestLessonStage : public QObject, private LessonFixture {
    Q_OBJECT

private slots:
    void initTestCase() { writeStudy(); }
    void init() {
        show();
        useLook(Look{});
    }
    void cleanup() { close(); }

    void aLessonThatEndsOnTheFullScreenLeavesThePanelsInTheirPlaces() {
        open(study());
        window().faces().choose(Face::teach);
        auto* panel = child<QDockWidget>("dock.lessons");
        enter(smallLesson());
        QCOMPARE(window().dockWidgetArea(panel), Qt::LeftDockWidgetArea);
        child<QAction>("view.fullScreen")->trigger();
        QVERIFY(!panel->isHidden());
        player().leave();
        QVERIFY(!window().isFullScreen());
        QCOMPARE(window().dockWidgetArea(panel), Qt::RightDockWidgetArea);
        waitUntilIdle();
    }

    /// Begun before a study is open, as a class may.
    void whatToLookAtIsOutlinedBesideTheWords() {
        window().faces().choose(Face::teach);
        for (const char* closed : {"dock.lessons", "dock.otfEditor"}) child<QDockWidget>(closed)->hide();
        enter(smallLesson());
        QVERIFY(!child<QDockWidget>("dock.lessons")->isHidden());
        QVERIFY(child<QDockWidget>("dock.otfEditor")->isHidden());
        const auto outlined = [this] {
            QRect around;
            for (int side = 0; side < 4; ++side) {
                const QWidget* strip = child(QStringLiteral("lessons.outline.%1").arg(side));
                if (strip->isVisible()) around |= strip->geometry();
            }
            return around;
        };
        const auto placeOf = [this](const QString& name) {
            const QWidget* widget = child(name);
            return QRect(widget->mapTo(&window(), QPoint(0, 0)), widget->size());
        };
        QTRY_COMPARE(outlined(), placeOf("view3d"));
        window().resize(1100, 720);
        QTRY_COMPARE(outlined(), placeOf("view3d"));
        click("lessons.next");
        QTRY_COMPARE(outlined(), placeOf("otfEditor.active.parabolic"));
        QVERIFY(!child("lessons.text")->visibleRegion().isEmpty());
        QVERIFY(!child("otfEditor.active.parabolic")->visibleRegion().isEmpty());
        child<QDockWidget>("dock.method")->raise();
        QTRY_VERIFY(outlined().isEmpty());  // its panel is behind another one
        child<QDockWidget>("dock.otfEditor")->raise();
        QTRY_COMPARE(outlined(), placeOf("otfEditor.active.parabolic"));
        click("lessons.next");
        QTRY_VERIFY(outlined().isEmpty());

        // Nothing of it is a person's work, in this lesson and in the next one.
        window().document().change("box", [](Document& next) { next.scene.box.on = true; });
        waitUntilIdle();
        QVERIFY(!window().isWindowModified());
        enter(smallLesson());
        player().leave();
        QVERIFY(!player().playing());
        for (const char* closed : {"dock.lessons", "dock.otfEditor"}) QVERIFY(child<QDockWidget>(closed)->isHidden());
        open(study());
        QVERIFY(document().panes[0].curve == CurveKind::adaptive);
        QVERIFY(!document().scene.box.on);
        QVERIFY(!window().sessionKeeping().isAside());
        QVERIFY(window().sessionKeeping().leftUnsaved().list().empty());
    }

    /// As it was in the window, which no document holds.
    void theStageIsGivenBack() {
        open(study());
        auto& panes = *window().findChild<PaneGrid*>();
        auto& theory = *child<TheoryPanel>("theory");
        panes.setPaneLayout(PaneLayout::large3d);
        window().tubeCoreChoice().setShown(true);
        TheorySetting own;
        own.scale = 1.75;
        theory.setSetting(own);
        enter(smallLesson());
        QCOMPARE(panes.paneLayout(), PaneLayout::only3d);
        QVERIFY(!window().tubeCoreChoice().shown());
        QVERIFY(theory.setting() == TheorySetting{});
        click("lessons.next");
        panes.setPaneLayout(PaneLayout::quad);
        window().tubeCoreChoice().setShown(true);
        TheorySetting changed;
        changed.scale = 0.5;
        theory.setSetting(changed);
        click("lessons.reset");
        QVERIFY(theory.setting() == TheorySetting{});
        theory.setSetting(changed);
        player().leave();
        QCOMPARE(panes.paneLayout(), PaneLayout::large3d);
        QVERIFY(window().tubeCoreChoice().shown());
        QVERIFY(theory.setting() == own);
        waitUntilIdle();
    }

    /// For the last row of a class.
    void onTheFullScreenTheWordsStayAndAreLarger() {
        window().resize(1600, 1000);
        waitUntilIdle();
        const int column = child("dock.view")->width();
        enter(smallLesson());
        const auto* words = child("lessons.text");
        const QFont font = words->font();
        const auto toggle = [&] { QTest::keyClick(&window(), Qt::Key_F); };
        toggle();
        QTRY_VERIFY(words->isVisible() && child("dock.view")->isHidden());
        QVERIFY(words->font().pointSizeF() > 1.4 * font.pointSizeF());
        QTRY_VERIFY(child("lessons")->width() > 400);
        const double letters = words->font().pointSizeF();
        window().resize(1600, 1200);  // a window manager gives the screen's size later
        QTRY_VERIFY(words->font().pointSizeF() > 1.1 * letters);
        click("lessons.next");  // the step looks at a button of the curve's panel
        QTRY_VERIFY(child("otfEditor.active.parabolic")->isVisible());
        child<QAbstractButton>("otfEditor.active.parabolic")->click();
        click("lessons.next");  // looks at nothing
        QTRY_VERIFY(!child("otfEditor.active.parabolic")->isVisible());
        toggle();
        QTRY_VERIFY(!child("dock.view")->isHidden());
        QCOMPARE(words->font().pointSizeF(), font.pointSizeF());
        QVERIFY(words->isVisible());
        toggle();
        player().leave();
        QTRY_COMPARE(child("dock.view")->width(), column);
        waitUntilIdle();
    }
};

ECHOLUCENT_TEST_CLASS(TestLessonStage)
#include "test_lesson_stage.moc"
