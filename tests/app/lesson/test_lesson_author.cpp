// Lessons that a person writes in the window: made of snapshots, edited by its controls, kept, saved and played.
#include <QAction>
#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QPlainTextEdit>

#include "app/lesson/lesson_author.h"
#include "app/lesson/lesson_handouts.h"
#include "app/lesson/lesson_player.h"
#include "app/sessions/session_keeping.h"
#include "app/sessions/snapshots.h"
#include "io/lesson/lesson_file.h"
#include "tests/app/window_fixture.h"
#include "widgets/lesson/lesson_editor.h"
#include "widgets/lesson/lessons_panel.h"

using namespace echolucent;

class TestLessonAuthor : public QObject, private WindowFixture {
    Q_OBJECT

private slots:
    void initTestCase() {
        lookAtNoPicture();
        lookAlongAssumedBeam();
        teach();
        m_file = file("heart.mha", {smallPhantom(PhantomScene::shapes, 5)});
    }
    void init() {
        show();
        useLook(Look{});
        child<QDockWidget>("dock.lessons")->show();
        child<QDockWidget>("dock.lessons")->raise();
    }
    void cleanup() { close(); }

    void aLessonIsMadeOfSnapshotsSavedAndPlayed() {
        openScan();
        QVERIFY(!child("lessons.new")->isEnabled());
        QVERIFY(child("lessons.new")->toolTip().contains("There is no snapshot"));
        keepSnapshots();
        QVERIFY(child("lessons.new")->isEnabled());
        click("lessons.new");
        QVERIFY(child("lessons.editor")->isVisible());
        QCOMPARE(child<QListWidget>("lessons.editor.steps")->count(), 3);
        QVERIFY(child<QListWidget>("lessons.editor.steps")->item(1)->text().contains("Squared"));

        // Each field says its sentence until it is right.
        QVERIFY(!child("lessons.editor.save")->isEnabled());
        QCOMPARE(problem("problem.title"), "⚠ The lesson needs a title of at most 120 bytes.");
        QTest::keyClicks(child<QLineEdit>("lessons.editor.title"), "Three curves");
        QVERIFY(child("lessons.editor.problem.title")->isHidden());
        for (int step = 0; step < 3; ++step) {
            choose(step);
            QCOMPARE(problem(fieldOf(LessonField::text)), "⚠ Write what is to be seen and done.");
            QTest::keyClicks(child<QPlainTextEdit>("lessons.editor.step.text"), "Look here.");
            QVERIFY(child("lessons.editor.step." + fieldOf(LessonField::text))->isHidden());
        }
        QVERIFY(child("lessons.editor.save")->isEnabled());

        choose(0);
        addCondition();
        addQuestion();
        pointAtTheCurveEditor();
        const LessonDraft& draft = *author().draft();
        QVERIFY(child("lessons.editor.save")->isEnabled());
        constexpr int widest = 329;
        QVERIFY2(child("lessons")->minimumSizeHint().width() <= widest,
                 qPrintable(QString::number(child("lessons")->minimumSizeHint().width())));
        QCOMPARE(draft.lesson.steps[0].lookAt, std::string("otfEditor.active.quartic"));

        // It is saved, and another reader finds all of it.
        QVERIFY(QDir(temporaryFolder().path()).mkpath("full"));
        QVERIFY(QFile::copy(m_file, temporaryFolder().filePath("full/heart.mha")));
        author().saveTo(temporaryFolder().filePath("full"));
        QVERIFY(draft.folder.empty());  // it is no lesson's folder
        const QString folder = temporaryFolder().filePath("three curves");
        author().saveTo(folder);
        QVERIFY(draftFolder().isEmpty());
        const auto saved = readLesson(folder.toStdString());
        QVERIFY2(saved, saved ? "" : saved.error().sentence().c_str());
        QVERIFY(*saved == draft.lesson);
        QCOMPARE(saved->steps[0].until->name, std::string("panes[0].curve"));
        QVERIFY(saved->steps[0].solved->panes[0].curve == CurveKind::quartic);
        QCOMPARE(saved->texts[0].steps[0].answers, (std::vector<std::string>{"No", "Yes"}));
        QCOMPARE(saved->steps[0].right, std::size_t{1});

        // It is played from the chosen step, by its own condition, and the editor comes back.
        choose(1);
        click("lessons.editor.play");
        QTRY_VERIFY(window().lessonPlayer().playing());
        waitUntilIdle();
        QCOMPARE(window().lessonPlayer().step(), std::size_t{1});
        QVERIFY(document().panes[0].curve == CurveKind::parabolic);
        click("lessons.back");
        QVERIFY(document().panes[0].curve == CurveKind::linear);
        QVERIFY(!window().lessonPlayer().isDone());
        child<QAbstractButton>("otfEditor.active.quartic")->click();
        QVERIFY(window().lessonPlayer().isDone());
        click("lessons.leave");
        QVERIFY(child("lessons.editor")->isVisible());
        QCOMPARE(child<QLineEdit>("lessons.editor.title")->text(), "Three curves");
        QVERIFY(author().draft()->lesson == *saved);
        click("lessons.editor.close");
        QVERIFY(!child("lessons.draft")->isEnabled());  // all of it is saved
        QVERIFY(child("lessons.list")->isVisible());

        // Its folder opens as a study does, and its handout shows the lesson's scan, whatever is open.
        open(m_file);
        const QString page = temporaryFolder().filePath("three curves.html");
        window().lessonHandouts().save(*saved, "en", page);
        waitUntilIdle();
        QFile handout(page);
        QVERIFY(handout.open(QIODevice::ReadOnly));
        const QByteArray text = handout.readAll();
        QVERIFY(text.contains("<h2>2. Squared</h2>") && text.contains("<strong>1. (b)</strong> Yes"));
        QVERIFY(!text.contains("heart"));
        QCOMPARE(text.count("<img "), qsizetype{3});
        window().open(folder);
        QTRY_VERIFY(window().lessonPlayer().playing());
        waitUntilIdle();
        QCOMPARE(child<QLabel>("lessons.title")->text(), "Straight");
        click("lessons.leave");
        waitUntilIdle();
    }

    void stepsAreAddedMovedAndShown() {
        openScan();
        keepSnapshots();
        click("lessons.new");
        DocumentModel& model = window().document();
        model.change("curve", [](Document& next) { next.panes[0].curve = CurveKind::quartic; });
        choose(0);
        click("lessons.editor.add");
        const LessonDraft& draft = *author().draft();
        QCOMPARE(draft.lesson.steps.size(), std::size_t{4});
        QCOMPARE(draft.step, std::size_t{1});
        QVERIFY(draft.lesson.steps[1].set->panes[0].curve == CurveKind::quartic);
        click("lessons.editor.up");
        QCOMPARE(draft.step, std::size_t{0});
        QVERIFY(draft.lesson.steps[0].set->panes[0].curve == CurveKind::quartic);
        QVERIFY(!child("lessons.editor.up")->isEnabled());
        choose(1);
        click("lessons.editor.step.show");
        QVERIFY(document().panes[0].curve == CurveKind::linear);
        model.steps().undo();
        QVERIFY(document().panes[0].curve == CurveKind::quartic);
        click("lessons.editor.step.take");
        QVERIFY(draft.lesson.steps[1].set->panes[0].curve == CurveKind::quartic);
        click("lessons.editor.step.goOn");
        QVERIFY(!draft.lesson.steps[1].set);
        choose(0);
        click("lessons.editor.remove");
        QCOMPARE(draft.lesson.steps.size(), std::size_t{3});

        // Nothing is lost if another study is opened; views are taken of the lesson's scan alone.
        const Lesson before = draft.lesson;
        open(m_file);
        QVERIFY(!child("lessons.new")->isEnabled());
        QVERIFY2(child("lessons.new")->toolTip().contains("It holds no voxels"),
                 qPrintable(child("lessons.new")->toolTip()));
        QVERIFY(author().draft()->lesson == before);
        for (const char* name : {"lessons.editor.add", "lessons.editor.step.take", "lessons.editor.step.solve"})
            QVERIFY(!child(name)->isEnabled());
        click("lessons.editor.step.show");
        QTRY_VERIFY(std::holds_alternative<SimulatedScan>(document().study));
        waitUntilIdle();
        QVERIFY(child("lessons.editor.add")->isEnabled());
        QVERIFY(document().panes[0].curve == draft.lesson.begins.panes[0].curve);
    }

    void whatWasTypedIsThereAtTheNextStart() {
        author().editCopy(window().lessonPlayer().lessons()[0]);
        QTest::keyClicks(child<QLineEdit>("lessons.editor.title"), " again");
        QTest::keyClicks(child<QPlainTextEdit>("lessons.editor.step.text"), "## half a heading ");
        const LessonDraft typed = *author().draft();
        QVERIFY(!child("lessons.editor.save")->isEnabled());
        close();
        showAgain();
        child<QDockWidget>("dock.lessons")->show();
        child<QDockWidget>("dock.lessons")->raise();
        QTRY_VERIFY(child("lessons.draft")->isEnabled());
        QAction* draft = window().findChild<QAction*>("lessons.draft.0");
        QVERIFY(draft != nullptr);
        QCOMPARE(draft->text(), QString::fromStdString(typed.lesson.texts[0].title));
        {
            MainWindow other(settingsFile());
            other.lessonAuthor().continueDraft(draftFolder());
            QVERIFY(other.lessonAuthor().draft());
            draft->trigger();
            QCoreApplication::processEvents();
            QVERIFY(!author().draft());  // the other window has it
            QVERIFY(child<MessageBar>("message")->text().contains("another window"));
        }
        draft->trigger();
        QTRY_VERIFY(author().draft());
        QVERIFY(author().draft()->lesson == typed.lesson);

        click("lessons.editor.discard");
        QVERIFY(child("lessons.list")->isVisible());
        QVERIFY(!child("lessons.draft")->isEnabled());
        click("message.action.0");
        QVERIFY(author().draft() && author().draft()->lesson == typed.lesson);
        click("lessons.editor.discard");
        QVERIFY(draftFolder().isEmpty());
    }

private:
    [[nodiscard]] const Document& document() { return window().document().document(); }
    [[nodiscard]] LessonAuthor& author() { return window().lessonAuthor(); }
    void openScan() {
        window().openStudy().openSimulatedScan(SimulatedScan{PhantomScene::fetus, {48, 48, 40}, 7});
        QTRY_VERIFY(std::holds_alternative<SimulatedScan>(document().study) && window().idle());
    }
    void keepSnapshots() {
        for (const auto& [name, curve] :
             {std::pair("Straight", CurveKind::linear), std::pair("Squared", CurveKind::parabolic),
              std::pair("Adaptive", CurveKind::adaptive)}) {
            window().document().change("curve", [curve = curve](Document& next) { next.panes[0].curve = curve; });
            QVERIFY(window().sessionKeeping().snapshots().keep(name, document()).isEmpty());
        }
    }
    void choose(int step) { child<QListWidget>("lessons.editor.steps")->setCurrentRow(step); }
    [[nodiscard]] QString problem(const QString& name) {
        auto* label = window().findChild<QLabel*>("lessons.editor." + name);
        if (label == nullptr) label = child<QLabel>("lessons.editor.step." + name);
        return label->text();
    }
    [[nodiscard]] static QString fieldOf(LessonField field) {
        return QStringLiteral("problem.%1").arg(static_cast<int>(field));
    }
    [[nodiscard]] QString draftFolder() {
        const QDir drafts(Settings(settingsFile()).dataFolder() + "/lesson-drafts");
        const QStringList names = drafts.entryList(QDir::Dirs | QDir::NoDotAndDotDot);
        return names.isEmpty() ? QString() : drafts.filePath(names.first());
    }
    /// The name is typed, and the present value fills itself in.
    void addCondition() {
        window().document().change("curve", [](Document& next) { next.panes[0].curve = CurveKind::quartic; });
        click("lessons.editor.condition.add");
        const QString sentence = fieldOf(LessonField::condition);
        QCOMPARE(problem(sentence), "⚠ The condition must name a value.");
        auto* name = child<QComboBox>("lessons.editor.condition.name.0");
        QVERIFY(name->findText("panes[0].curve") >= 0 && name->findText("measured.panes[3].right") >= 0);
        name->lineEdit()->setText("panes[0].corve");
        QVERIFY2(problem(sentence).contains("neither a value"), qPrintable(problem(sentence)));
        name->lineEdit()->setText("panes[0].curve");
        QTest::keyClick(name->lineEdit(), Qt::Key_Return);
        QCOMPARE(child<QLineEdit>("lessons.editor.condition.value.0")->text(), "quartic");
        QVERIFY(child("lessons.editor.step." + sentence)->isHidden());
        const auto* solution = child<QLabel>("lessons.editor.step.solution");
        QCOMPARE(solution->text(), "No view solves the step.");
        click("lessons.editor.step.solve");
        QCOMPARE(solution->text(), "A view solves the step. The condition holds there.");
    }
    void addQuestion() {
        QTest::keyClicks(child<QPlainTextEdit>("lessons.editor.question.words"), "Why?");
        QCOMPARE(problem(fieldOf(LessonField::question)), "⚠ A question has 2 to 6 answers.");
        for (int answer = 0; answer < 2; ++answer) click("lessons.editor.question.add");
        QTest::keyClicks(child<QLineEdit>("lessons.editor.question.answer.0"), "No");
        QCOMPARE(problem(fieldOf(LessonField::question)), "⚠ Write each answer, or remove it.");
        QTest::keyClicks(child<QLineEdit>("lessons.editor.question.answer.1"), "Yes");
        click("lessons.editor.question.right.1");
        QVERIFY(child("lessons.editor.step." + fieldOf(LessonField::question))->isHidden());
    }
    /// The click names the control and does nothing else.
    void pointAtTheCurveEditor() {
        auto* target = child<QComboBox>("lessons.editor.step.target");
        target->setEditText("no.control");
        QCOMPARE(problem(fieldOf(LessonField::target)), "⚠ The window has no control of this name.");
        const CurveKind before = document().panes[0].curve;
        child<QDockWidget>("dock.otfEditor")->show();
        click("lessons.editor.step.point");
        QVERIFY(child<QAbstractButton>("lessons.editor.step.point")->isChecked());
        QTest::mouseClick(child("otfEditor.active.quartic"), Qt::LeftButton);
        QCOMPARE(target->currentText(), "otfEditor.active.quartic");
        QVERIFY(document().panes[0].curve == before);
        QVERIFY(!child<QAbstractButton>("lessons.editor.step.point")->isChecked());
        // A control of another panel is reached through its tab, and the editor comes back.
        click("lessons.editor.step.point");
        click("dock.lessons.tab.method");
        QTRY_VERIFY(!child("adaptive.compute")->visibleRegion().isEmpty());
        QVERIFY(child<QAbstractButton>("lessons.editor.step.point")->isChecked());
        QTest::mouseClick(child("adaptive.compute"), Qt::LeftButton);
        QCOMPARE(target->currentText(), "adaptive.compute");
        QTRY_VERIFY(!child("lessons.editor")->visibleRegion().isEmpty());
        target->setEditText("otfEditor.active.quartic");
        click("lessons.editor.step.point");
        QTest::keyClick(&window(), Qt::Key_Escape);
        QVERIFY(!child<QAbstractButton>("lessons.editor.step.point")->isChecked());
        QCOMPARE(target->currentText(), "otfEditor.active.quartic");
    }

    QString m_file;
};

ECHOLUCENT_TEST_CLASS(TestLessonAuthor)
#include "test_lesson_author.moc"
