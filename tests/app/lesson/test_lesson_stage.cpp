// What a lesson does with the window: where its words stand, what it outlines, and what it gives back.
#include <QAbstractButton>
#include <QAction>
#include <QDockWidget>
#include <QLabel>
#include <QPointer>
#include <QScrollArea>
#include <algorithm>

#include "app/compare/compare_room.h"
#include "app/explain/tube_core_choice.h"
#include "app/lesson/lesson_player.h"
#include "app/sessions/session_keeping.h"
#include "app/window/window_faces.h"
#include "processing/designers/choice/designer_config.h"
#include "processing/document/panes.h"
#include "tests/app/lesson/lesson_fixture.h"
#include "widgets/controls/dock_around.h"
#include "widgets/larger_letters.h"
#include "widgets/lesson/lesson_outline.h"
#include "widgets/planes/pane_grid.h"
#include "widgets/plots/plot_canvas.h"
#include "widgets/theory/theory_panel.h"

using namespace echolucent;

namespace {

/// The small lesson, with a step for each of these that looks at it.
Lesson lessonLookingAt(const std::vector<std::string>& targets) {
    Lesson lesson = smallLesson();
    lesson.steps.clear();
    lesson.texts[0].steps.clear();
    for (std::size_t i = 0; i < targets.size(); ++i) {
        lesson.steps.push_back({.id = "step-" + std::to_string(i), .lookAt = targets[i]});
        if (targets[i].starts_with("compare.")) {
            lesson.steps.back().set = lesson.begins;
            lesson.steps.back().set->panes = {{.curve = CurveKind::linear}, {.curve = CurveKind::parabolic}};
        }
        lesson.texts[0].steps.push_back({"Step", "Look."});
    }
    return lesson;
}

std::vector<std::pair<QPointer<QWidget>, QFont>> fontsIn(const QWidget& place) {
    std::vector<std::pair<QPointer<QWidget>, QFont>> fonts;
    for (QWidget* each : place.findChildren<QWidget*>()) fonts.emplace_back(each, each->font());
    return fonts;
}

}  // namespace

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
        // What fills its place is outlined within, all else around.
        const auto around = [&placeOf](const QString& name) {
            constexpr int width = LessonOutline::width;
            return placeOf(name).adjusted(-width, -width, width, width);
        };
        QTRY_COMPARE(outlined(), placeOf("view3d"));
        window().resize(1100, 720);
        QTRY_COMPARE(outlined(), placeOf("view3d"));
        click("lessons.next");
        QTRY_COMPARE(outlined(), around("otfEditor.active.parabolic"));
        QVERIFY(!child("lessons.text")->visibleRegion().isEmpty());
        QVERIFY(!child("otfEditor.active.parabolic")->visibleRegion().isEmpty());
        child<QDockWidget>("dock.method")->raise();
        QTRY_VERIFY(outlined().isEmpty());  // its panel is behind another one
        child<QDockWidget>("dock.otfEditor")->raise();
        QTRY_COMPARE(outlined(), around("otfEditor.active.parabolic"));
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
        QVERIFY(child<QAbstractButton>("compare.insets")->isChecked());
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
        auto* insets = child<QAbstractButton>("compare.insets");
        QVERIFY(!insets->isChecked());
        insets->setChecked(true);
        enter(smallLesson());
        player().leave();
        QVERIFY(insets->isChecked());
        insets->setChecked(false);
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
        window().resize(1024, 768);  // too narrow: the picture needs the room
        QTRY_COMPARE(words->font().pointSizeF(), font.pointSizeF());
        window().resize(1920, 1200);  // a window manager gives the screen's size later
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

    /// Each panel that the program's lessons look at.
    void onTheFullScreenThePanelThatAStepLooksAtIsLargerToo() {
        window().resize(1280, 800);
        const std::vector<std::string> targets{"view.reduction",       "otfEditor.canvas", "adaptive.advanced",
                                               "tubeCores.map",        "compare.table",    "motion.mapPanel",
                                               "designer.explanation", "theory.words"};
        enter(lessonLookingAt(targets));
        const auto lookedAt = [&](std::size_t step) { return child(QString::fromStdString(targets[step])); };
        for (std::size_t step = 0; step < targets.size(); ++step) {
            QTRY_VERIFY(lookedAt(step)->isVisible());
            auto* dock = dockAround(lookedAt(step));
            const auto fonts = fontsIn(*dock);
            QTRY_VERIFY(child("lessons")->width() < 400);
            const int width = dock->width(), words = child("dock.lessons")->width();

            QTest::keyClick(&window(), Qt::Key_F);
            window().resize(1920, 1080);
            QTRY_VERIFY2(dock->width() > 580 && dock->width() < 640, qPrintable(QString::number(dock->width())));
            QTRY_VERIFY(window().centralWidget()->width() > 0.38 * 1920);
            const auto* area = dock->findChild<QScrollArea*>();
            QVERIFY(area->widget()->width() <= area->viewport()->width());
            for (const QWidget* each : dock->findChildren<QWidget*>()) {
                if (!each->isVisible()) continue;
                const QByteArray name = each->metaObject()->className() + each->objectName().toUtf8();
                QVERIFY2(lettersOf(*each) > 1.7, name);
                const bool hasWords = qobject_cast<const QLabel*>(each) || qobject_cast<const QAbstractButton*>(each);
                if (hasWords) QVERIFY2(each->width() >= each->minimumSizeHint().width(), name);
            }

            // The next step looks at another panel, and hides this one.
            const std::size_t next = std::min(step + 1, targets.size() - 1);
            if (next > step) click("lessons.next");
            QTest::keyClick(&window(), Qt::Key_F);
            QTRY_VERIFY2(dockAround(lookedAt(next))->width() == width, targets[step].c_str());
            QTRY_COMPARE(child("dock.lessons")->width(), words);
            for (const auto& [widget, font] : fonts) QVERIFY(!widget || widget->font() == font);
        }
        waitUntilIdle();
    }

    void plotsAndControlsThatComeLaterAreLargerToo() {
        window().resize(1920, 1080);
        enter(lessonLookingAt({"theory.contrastPlot", "designer.explanation", "view3d"}));
        auto* plot = child<PlotCanvas>("theory.contrastPlot");
        QTRY_VERIFY(plot->isVisible());
        const int height = plot->height(), atRest = plot->heightForWidth(300);
        QTest::keyClick(&window(), Qt::Key_F);
        window().resize(1920, 1080);
        QTRY_VERIFY(plot->width() > 540 && plot->height() > 1.6 * height);
        click("lessons.next");
        QTRY_VERIFY(child("designer.explanation")->isVisible());
        QCOMPARE(plot->heightForWidth(300), atRest);
        QVERIFY(lettersOf(*plot) == 1.0);
        window().document().change("designer",
                                   [](Document& next) { next = withDesigner(next, firstPane, KindlmannConfig{}); });
        QTRY_VERIFY(child("designer.prefilter")->isVisible());
        QTRY_VERIFY(lettersOf(*child("designer.prefilter")) > 1.7);
        click("lessons.next");
        QTRY_VERIFY(!child("designer.explanation")->isVisible());
        QVERIFY(lettersOf(*child("designer.prefilter")) == 1.0);
        player().leave();
        waitUntilIdle();
    }

    /// The designer's words come once the OTF is computed.
    void textsThatAreComputedAreWholeInSight() {
        Lesson lesson = lessonLookingAt({"view3d", "designer.explanation"});
        Document kindlmann = withDesigner(lesson.begins, firstPane, KindlmannConfig{});
        lesson.steps[1].set = kindlmann;
        for (const bool full : {false, true}) {
            window().resize(1280, 720);
            enter(lesson);
            if (full) QTest::keyClick(&window(), Qt::Key_F);
            window().resize(1280, 720);
            click("lessons.next");
            waitUntilIdle();
            auto* words = child<QLabel>("designer.explanation");
            QTRY_VERIFY(words->text().size() > 100);
            const auto* area = dockAround(words)->findChild<QScrollArea*>();
            const auto inSight = [&] {
                const int top = words->mapTo(area->viewport(), QPoint(0, 0)).y(), seen = area->viewport()->height();
                const bool whole = top >= 0 && top + words->height() <= seen;
                return words->height() > seen ? top >= 0 && top < 20 : whole;
            };
            QTRY_VERIFY(words->height() >= words->heightForWidth(words->width()) && inSight());
            player().leave();
            waitUntilIdle();
        }
    }
};

ECHOLUCENT_TEST_CLASS(TestLessonStage)
#include "test_lesson_stage.moc"
