// Lessons in the window: entered and left like a session, played step by step, and the way back.
#include <QAction>
#include <QBuffer>
#include <QDockWidget>
#include <QLabel>
#include <QRadioButton>
#include <thread>

#include "app/compare/compare_room.h"
#include "app/explain/tube_core_choice.h"
#include "app/lesson/lesson_player.h"
#include "app/lesson/shipped_lessons.h"
#include "app/sessions/session_keeping.h"
#include "app/window/window_faces.h"
#include "processing/adaptive/method_reading.h"
#include "processing/document/panes.h"
#include "tests/app/lesson/lesson_fixture.h"
#include "widgets/lesson/lesson_text_view.h"
#include "widgets/lesson/lessons_panel.h"

using namespace echolucent;

class TestLessons : public QObject, private LessonFixture {
    Q_OBJECT

private slots:
    void initTestCase() { writeStudy(); }
    void init() {
        if (QTest::currentTestFunction() == QByteArray("aStrangersTextLoadsNothingBesideTheLessonsImages")) return;
        show();
        useLook(Look{});
    }
    void cleanup() { close(); }

    void aLessonIsLeftWithTheWorkAndTheHistoryThatItFound() {
        open(study());
        DocumentModel& model = window().document();
        for (const double brightness : {1.2, 1.4, 1.6})
            model.change("brightness", [&](Document& next) { next.scene.look.brightness = brightness; });
        model.steps().undo();
        QVERIFY(window().sessionKeeping().snapshots().keep("mine", document()).isEmpty());
        waitUntilIdle();
        const Document before = document();
        const Study* study = window().openStudy().study();
        const int count = model.steps().count(), index = model.steps().index();
        QCOMPARE(index, count - 1);

        enter(smallLesson());
        QCOMPARE(window().faces().face(), Face::teach);
        QVERIFY(document().study == smallLesson().begins.study);
        QVERIFY(document().panes[0].curve == CurveKind::linear);
        QVERIFY(window().sessionKeeping().snapshots().list().empty());
        QVERIFY(!window().isWindowModified());
        model.change("box", [](Document& next) { next.scene.box.on = true; });
        waitUntilIdle();

        player().leave();
        QVERIFY(!player().playing());
        QVERIFY(document() == before);
        QCOMPARE(window().openStudy().study(), study);
        QCOMPARE(window().faces().face(), Face::review);
        QCOMPARE(model.steps().count(), count);
        QCOMPARE(model.steps().index(), index);
        QCOMPARE(window().sessionKeeping().snapshots().list().size(), std::size_t{1});
        QTRY_VERIFY(window().isWindowModified());  // the snapshot is not saved
        model.steps().redo();
        QCOMPARE(document().scene.look.brightness, 1.6);
        model.steps().setIndex(0);
        QCOMPARE(document().scene.look.brightness, Look{}.brightness);
        waitUntilIdle();
    }

    /// Its panes are there while the voxels are still those of the lesson, and only the first pane has any.
    void aComparisonComesBackWithItsStudy() {
        open(study());
        const auto compared = [](Document& next) { next = withPaneCount(next, 3); };
        window().document().change("panes", compared);
        waitUntilIdle();
        const Document before = document();
        enter(smallLesson());
        QVERIFY(!window().compareRoom().shown());
        connect(&window().compareRoom(), &CompareRoom::shownChanged, this, [] {
            for (int turn = 0; turn < 20'000; ++turn)
                std::this_thread::yield();  // the ray caster's thread has its turn
        });
        player().leave();
        QVERIFY(window().compareRoom().shown());
        QVERIFY(document() == before);
        waitUntilIdle();
        QVERIFY(window().compareRoom().views().settled());
    }

    void stepsArePlayedForthAndBack() {
        open(study());
        enter(smallLesson());
        DocumentModel& model = window().document();
        QCOMPARE(child<QLabel>("lessons.progress")->text(), "Step 1 of 3");
        QVERIFY(!child("lessons.back")->isEnabled());
        QVERIFY(child("lessons.skip")->isHidden());  // there is nothing to do
        QVERIFY(child("lessons.explanation")->isHidden());
        child<QRadioButton>("lessons.answer.0")->click();
        QCOMPARE(child<QLabel>("lessons.verdict")->text(), "No. Try again.");
        QVERIFY(child("lessons.explanation")->isHidden());
        child<QRadioButton>("lessons.answer.1")->click();
        QCOMPARE(child<QLabel>("lessons.verdict")->text(), "Right.");
        QVERIFY(!child<QRadioButton>("lessons.answer.0")->isChecked());
        QVERIFY(!child("lessons.explanation")->isHidden());

        const int steps = model.steps().count();
        click("lessons.next");
        QCOMPARE(player().step(), std::size_t{1});
        QCOMPARE(model.steps().count(), steps);  // the step sets nothing
        QVERIFY(!player().isDone());
        QCOMPARE(child<QLabel>("lessons.done")->text(), "To do.");
        QVERIFY(child("lessons.hintText")->isHidden());
        click("lessons.hint");
        QVERIFY(!child("lessons.hintText")->isHidden());
        child<QAbstractButton>("otfEditor.active.parabolic")->click();
        QVERIFY(document().panes[0].curve == CurveKind::parabolic);
        QVERIFY(player().isDone());
        QCOMPARE(child<QLabel>("lessons.done")->text(), "✓ Done.");
        model.change("curve", [](Document& next) { next.panes[0].curve = CurveKind::quartic; });
        QVERIFY(player().isDone());  // what was done stays done
        click("lessons.reset");
        QVERIFY(document().panes[0].curve == CurveKind::linear);

        const int before = model.steps().count();
        click("lessons.skip");
        QCOMPARE(player().step(), std::size_t{1});  // a class sees what was done
        QVERIFY(document().panes[0].curve == CurveKind::parabolic);
        click("lessons.next");
        QCOMPARE(player().step(), std::size_t{2});
        QCOMPARE(model.steps().count(), before + 2);
        QVERIFY(window().compareRoom().shown());
        QCOMPARE(document().panes.size(), std::size_t{2});
        QCOMPARE(document().scene.motionAngle, 12.5);
        model.steps().undo();
        QCOMPARE(document().scene.motionAngle, 0.0);
        model.steps().redo();
        QCOMPARE(document().scene.motionAngle, 12.5);
        QVERIFY(!player().isDone());
        QTRY_VERIFY(player().isDone());  // once it is measured
        QCOMPARE(child<QAbstractButton>("lessons.next")->text(), "Finish");
        click("lessons.back");
        QCOMPARE(player().step(), std::size_t{1});
        QVERIFY(!window().compareRoom().shown());
        QVERIFY(document().panes[0].curve == CurveKind::linear);  // as the step began
        click("lessons.next");
        click("lessons.next");
        QVERIFY(!player().playing());
        QVERIFY(std::holds_alternative<StudyFile>(document().study));
        waitUntilIdle();
    }

    void whatWasMeasuredOfOtherPanesDoesNotCount() {
        Lesson lesson = smallLesson();
        Document first = lesson.begins;
        first.panes = {{.curve = CurveKind::adaptive}, {.curve = CurveKind::quartic}};
        Document second = first;
        std::get<RampRule>(second.method.config.curve).aim = 0.0;
        Document third = first;  // its adaptive OTF is kept from the first step, and arrives at once
        third.panes[1].curve = CurveKind::linear;
        const LessonCondition quartic{ConditionKind::greater, "measured.panes[1].never", 1.0};
        lesson.steps.clear();
        lesson.texts[0].steps.clear();
        for (const Document& set : {first, second, third}) {
            LessonStep step{.id = "step-" + std::to_string(lesson.steps.size()), .set = set};
            step.until = quartic;
            lesson.steps.push_back(step);
            lesson.texts[0].steps.push_back({"Wait", "Wait."});
        }
        player().enter(lesson);
        QTRY_VERIFY(player().isDone());
        click("lessons.next");
        QTRY_VERIFY(player().isDone());
        click("lessons.next");
        QVERIFY(!player().isDone());
        QTRY_VERIFY(player().measured("measured.panes[1].never"));
        QVERIFY(player().measured("measured.panes[1].never") == DocumentValue(0.0));
        QVERIFY(!player().isDone());
    }

    void anotherStudyEndsTheLessonAndLeavesTheWorkUnsaved() {
        open(study());
        window().document().change("own", [](Document& next) {
            next.scene.box.on = true;
            next.scene.look.brightness = 1.25;
            next.curves.parabolic.scale = 1.75;
            next.method.config = configOf(MethodReading::asPublished);
        });
        const Document own = document();
        waitUntilIdle();
        enter(smallLesson());
        window().document().change("of the lesson", [](Document& next) {
            next.curves.parabolic.scale = 4;
            next.scene.look.brightness = 0.5;
        });
        waitUntilIdle();
        QVERIFY(window().sessionKeeping().leftUnsaved().list().empty());
        window().open(study());
        player().leave();  // the study that was asked for wins
        QVERIFY(player().playing());
        QTRY_VERIFY(!player().playing());
        waitUntilIdle();
        QVERIFY(document().curves == own.curves && document().method == own.method);
        QCOMPARE(document().scene.look.brightness, 1.25);
        QVERIFY(document().panes == own.panes);
        QCOMPARE(window().sessionKeeping().leftUnsaved().list().size(), std::size_t{1});
        QVERIFY(child("lessons.list")->isVisibleTo(child("lessons")));
        player().leave();  // there is nothing to leave
        QVERIFY(std::holds_alternative<StudyFile>(document().study));
    }

    void aStudyThatIsAskedForMeanwhileWinsOverTheLesson() {
        player().enter(smallLesson());
        open(study());
        QVERIFY(!player().playing());
        QVERIFY(std::holds_alternative<StudyFile>(document().study));
        QVERIFY(!window().sessionKeeping().isAside());
        QVERIFY(window().sessionKeeping().leftUnsaved().list().empty());
    }

    void aStepIsDoneByTheTubeCoreThatItAsksFor() {
        Lesson lesson = smallLesson();
        lesson.begins.panes[0].curve = CurveKind::adaptive;
        lesson.steps[0].until = LessonCondition{ConditionKind::equal, "measured.tube_core", 20.0};
        TubeCoreChoice& choice = window().tubeCoreChoice();
        enter(lesson);
        QVERIFY(!player().isDone());
        QVERIFY(!player().measured("measured.tube_core"));
        choice.choose(21);
        QVERIFY(player().measured("measured.tube_core") == DocumentValue(21.0));
        QVERIFY(!player().isDone());
        choice.choose(20);
        QVERIFY(player().isDone());
        choice.choose(std::nullopt);
        QVERIFY(player().isDone());  // what was done stays done

        click("lessons.next");
        click("lessons.back");
        choice.choose(21);
        click("lessons.skip");
        QCOMPARE(choice.number(), std::optional(20));
        QCOMPARE(player().step(), std::size_t{0});
        waitUntilIdle();
    }

    void shippedLessonsLookAtControlsThatExist() {
        QCOMPARE(player().lessons().size(), static_cast<std::size_t>(shippedLessons().size()));
        QVERIFY(!player().lessons().empty());
        for (const Lesson& lesson : player().lessons())
            for (const LessonStep& step : lesson.steps)
                QVERIFY2(step.lookAt.empty() || window().findChild<QWidget*>(QString::fromStdString(step.lookAt)),
                         step.lookAt.c_str());
    }

    void aStrangersTextLoadsNothingBesideTheLessonsImages() {
        QImage image(6, 4, QImage::Format_RGB32);
        image.fill(Qt::red);
        QByteArray bytes;
        QBuffer buffer(&bytes);
        buffer.open(QIODevice::WriteOnly);
        QVERIFY(image.save(&buffer, "PNG"));
        QVERIFY(image.save(temporaryFolder().filePath("other.png")));
        LessonTextView view;
        view.resize(300, 100);
        view.setImages({{"wall.png", bytes}, {"broken.png", bytes.left(30)}});
        const auto sizeOf = [&](const QString& name) {
            return view.loadResource(QTextDocument::ImageResource, QUrl(name)).value<QImage>().size();
        };
        QCOMPARE(sizeOf("wall.png"), QSize(6, 4));
        const QString other = temporaryFolder().filePath("other.png");
        for (const QString& name : {QStringLiteral("broken.png"), other, "file://" + other, QString("none.png")})
            QCOMPARE(sizeOf(name), QSize(1, 1));
        QVERIFY(view.loadResource(QTextDocument::StyleSheetResource, QUrl("wall.png")).value<QImage>().width() == 1);
        view.showMarkdown("<b>not bold</b> and <img src=\"" + other + "\">");
        QVERIFY2(view.toPlainText().contains("<b>not bold</b>"), qPrintable(view.toPlainText()));
        QVERIFY(!view.openLinks());

        QVERIFY(QImage(40, 400, QImage::Format_RGB32).save(other));
        const QString html = "<img src=\"" + other + "\">";
        LessonPage page{html, html, html, html, html, html};
        page.answers = {html, "![high](" + other + ")"};
        LessonsPanel panel;
        panel.resize(300, 500);
        panel.showPage(page);
        for (const char* name : {"lessons.lesson", "lessons.title"})
            QVERIFY2(panel.findChild<QLabel*>(name)->sizeHint().height() < 300, name);
        for (const char* name : {"lessons.answer.0", "lessons.answer.1"})
            QVERIFY2(panel.findChild<QWidget*>(name)->parentWidget()->sizeHint().height() < 300, name);
    }
};

ECHOLUCENT_TEST_CLASS(TestLessons)
#include "test_lessons.moc"
