// Tube cores in the real main window: a click anywhere chooses one, and the panel tells of it what the method says.
#include <QAbstractItemView>
#include <QAction>
#include <QCheckBox>
#include <QDockWidget>
#include <QFile>
#include <QImage>
#include <QLabel>
#include <QSlider>
#include <QTableWidget>
#include <algorithm>

#include "app/compare/compare_room.h"
#include "app/explain/tube_core_choice.h"
#include "app/explain/tube_core_explaining.h"
#include "app/explain/tube_core_overlay.h"
#include "app/explain/tube_core_page.h"
#include "app/explain/tube_cores_in_pictures.h"
#include "processing/adaptive/method_reading.h"
#include "processing/explanation/explanation_facts.h"
#include "tests/app/planes/room_fixture.h"
#include "tests/qt_program/test_classes.h"
#include "widgets/controls/message_bar.h"
#include "widgets/tube_cores/tube_core_list.h"
#include "widgets/tube_cores/tube_core_map.h"
#include "widgets/tube_cores/tube_core_panel.h"
#include "widgets/volume_view/scene/annotation/overlay.h"

using namespace echolucent;

class TestTubeCores : public QObject, private RoomFixture {
    Q_OBJECT

private slots:
    void initTestCase() {
        QLocale::setDefault(QLocale::c());
        teach();
        lookAlongAssumedBeam();
        m_file = file("fetus.mha", {smallPhantom(PhantomScene::fetus, 5)});
        m_other = file("shapes.mha", {smallPhantom(PhantomScene::shapes, 5)});
        show();
        window().resize(1280, 720);
        open(m_file);
        key(Qt::Key_F3);
        child<QDockWidget>("dock.tubeCores")->raise();
        QTRY_VERIFY(child("tubeCores")->isVisible());
        waitUntilIdle();
        QVERIFY(run()->tubesWithWeight > 20);
        QVERIFY(!choice().shown() && !child<QAction>("room.tubeCores")->isChecked());
        QVERIFY(overlay().discs.empty() && !pane("planes.a").tubeCores().marks);
    }
    void init() {
        choice().setShown(true);
        choice().choose(std::nullopt);
    }
    void cleanupTestCase() { close(); }

    void theyAreShownOnlyOnRequest() {
        choice().setShown(false);
        QVERIFY(overlay().discs.empty());
        QVERIFY(!pane("planes.a").tubeCores().marks);
        const int steps = window().document().steps().index();
        key(Qt::Key_T);
        QVERIFY(choice().shown() && child<QCheckBox>("tubeCores.shown")->isChecked());
        QVERIFY(!overlay().discs.empty());
        QVERIFY(pane("planes.a").tubeCores().marks);
        click("tubeCores.shown");
        QVERIFY(!choice().shown() && !child<QAction>("room.tubeCores")->isChecked());
        QVERIFY(overlay().discs.empty());
        QCOMPARE(window().document().steps().index(), steps);
    }

    void aClickAnywhereChoosesAndCastsNothingAnew() {
        waitUntilIdle();
        const auto picture = window().volumeView().picture();
        const Document before = document();
        const TubeCoreMarks marks = *window().tubeCoresInPictures().marks();
        const std::vector<int> in3d = tubeCoresIn3d(marks, std::nullopt);
        const int first = in3d.at(in3d.size() / 3), second = in3d.at(in3d.size() / 2);

        clickIn3d(seenIn3d(*marks.of(first)->surfaceMm));
        tellsOf(first);
        QTest::mouseClick(child("tubeCores.map"), Qt::LeftButton, {},
                          child<TubeCoreMap>("tubeCores.map")->cellOf(second).center().toPoint());
        tellsOf(second);
        const auto* list = child<TubeCoreList>("tubeCores.list");
        QCOMPARE(list->currentIndex().siblingAtColumn(0).data().toInt(), second);
        list->selectionModel()->setCurrentIndex(list->model()->index(first, 0), QItemSelectionModel::NoUpdate);
        tellsOf(first);
        for (const char* name : {"planes.a", "planes.b"}) {
            PlanePane& plane = pane(name);
            for (const TubeCoreMark& mark : marks.marks) {
                const PlaneView view = plane.mapping().view;
                const auto shown = shownInPlane(marks, mark, view.centreMm, view.frame.forward);
                if (!shown || !shown->surfaceMm || mark.number == choice().number()) continue;
                QTest::mouseClick(&plane, Qt::LeftButton, {}, plane.mapping().seenAt(*shown->surfaceMm).toPoint());
                tellsOf(mark.number);
                break;
            }
        }
        QCOMPARE(document(), before);
        QCOMPARE(window().volumeView().picture(), picture);
    }

    void aDragFromATubeCoreDoesWhatItDoesElsewhere() {
        const TubeCoreMarks marks = *window().tubeCoresInPictures().marks();
        const QPoint from = seenIn3d(*marks.of(tubeCoresIn3d(marks, {}).at(3))->surfaceMm);
        const Pose pose = document().scene.pose;
        dragIn3d(from, from + QPoint(60, 10));
        QVERIFY(document().scene.pose != pose);
        window().document().steps().undo();
        PlanePane& plane = pane("planes.a");
        const PlaneView view = plane.mapping().view;
        const auto mark = std::ranges::find_if(marks.marks, [&](const TubeCoreMark& each) {
            const auto shown = shownInPlane(marks, each, view.centreMm, view.frame.forward);
            return shown && shown->surfaceMm;
        });
        QVERIFY(mark != marks.marks.end());
        const QPointF at = plane.mapping().seenAt(*mark->surfaceMm);
        const Planes planes = document().scene.planes;
        const int steps = window().document().steps().index();
        drag(plane, at, at + QPointF(20, 25));
        QVERIFY(document().scene.planes != planes);
        QCOMPARE(window().document().steps().index(), steps + 1);
        window().document().steps().undo();
        QVERIFY(!choice().number());
    }

    void aDoubleClickOnATubeCoreGivesThePlaneTheWholeRoom() {
        const TubeCoreMarks marks = *window().tubeCoresInPictures().marks();
        PlanePane& plane = pane("planes.a");
        const QSize before = plane.size();
        const Planes planes = document().scene.planes;
        const int steps = window().document().steps().index();
        const PlaneView view = plane.mapping().view;
        const auto mark = std::ranges::find_if(marks.marks, [&](const TubeCoreMark& each) {
            const auto shown = shownInPlane(marks, each, view.centreMm, view.frame.forward);
            return shown && shown->surfaceMm;
        });
        QVERIFY(mark != marks.marks.end());
        const auto doubleClickOnIt = [&] {
            const QPoint at = plane.mapping().seenAt(*mark->surfaceMm).toPoint();
            QTest::mouseClick(&plane, Qt::LeftButton, {}, at);
            QTest::mouseDClick(&plane, Qt::LeftButton, {}, at);
        };
        doubleClickOnIt();
        QVERIFY(plane.width() > before.width() && plane.height() > before.height());
        QCOMPARE(choice().number(), mark->number);
        doubleClickOnIt();
        QCOMPARE(plane.size(), before);
        QCOMPARE(document().scene.planes, planes);
        QCOMPARE(window().document().steps().index(), steps);
    }

    void aToolInTheHandGetsTheClick() {
        key(Qt::Key_S);
        const TubeCoreMarks marks = *window().tubeCoresInPictures().marks();
        clickIn3d(seenIn3d(*marks.of(tubeCoresIn3d(marks, {}).at(3))->surfaceMm));
        QVERIFY(!choice().number());
        key(Qt::Key_S);
    }

    void thePanelTellsTheFactsOfBothReadings_data() {
        QTest::addColumn<int>("reading");
        QTest::newRow("as published") << static_cast<int>(MethodReading::asPublished);
        QTest::newRow("default") << static_cast<int>(MethodReading::standard);
    }
    void thePanelTellsTheFactsOfBothReadings() {
        QFETCH(int, reading);
        window().document().change("reading", [&](Document& next) {
            const OpacityCurve initial = next.method.config.initial;
            next.method.config = configOf(static_cast<MethodReading>(reading));
            next.method.config.initial = initial;
        });
        for (const int number : {0, 37, 80, 112, 127, 190}) {
            choice().choose(number);
            tellsOf(number);
        }
    }

    void aSliderOfTheReadingIsOneStepAndChangesTheFacts() {
        waitUntilIdle();
        const std::vector<int> heaviest = heaviestFirst(*run());
        choice().choose(heaviest.front());
        tellsOf(heaviest.front());
        const QStringList before = factsShown();
        click("tubeCores.parameters");
        const int steps = window().document().steps().index();
        auto* reach = child<QSlider>("tubeCores.lowReach");
        QTRY_VERIFY(reach->isVisible());
        reach->setFocus();  // else the key is the motion's
        const AdaptiveOtfConfig config = configOf(document());
        QTest::keyClick(reach, Qt::Key_Right);
        QCOMPARE(window().document().steps().index(), steps + 1);
        QCOMPARE(document().method.config.surface.lowReach, config.surface.lowReach + 1);
        QTRY_VERIFY(factsShown() != before);
        tellsOf(heaviest.front());
        window().document().steps().undo();
        QTRY_COMPARE(factsShown(), before);
        click("tubeCores.parameters");
    }

    void thePictureIsThinnedAndHoldsTheChosenOne() {
        const TubeCoreMarks marks = *window().tubeCoresInPictures().marks();
        const auto weighing = std::ranges::count_if(marks.marks, [](const auto& mark) { return mark.share > 0.0; });
        const std::vector<int> few = tubeCoresIn3d(marks, std::nullopt);
        QVERIFY(few.size() <= mostTubeCoresIn3d && few.size() < static_cast<std::size_t>(weighing));
        QCOMPARE(overlay().discs.size(), 2 * few.size());  // each with a rim
        const auto left = std::ranges::find_if(marks.marks, [&](const auto& mark) {
            return mark.surfaceMm && !std::ranges::binary_search(few, mark.number);
        });
        QVERIFY(left != marks.marks.end());
        choice().choose(left->number);
        QCOMPARE(tubeCoresIn3d(marks, left->number).size(), few.size() + 1);
        QCOMPARE(overlay().texts.size(), 1u);
        QCOMPARE(overlay().texts[0].text, std::to_string(left->number));
        const bool whole = std::ranges::any_of(overlay().spaceLines, [&](const SpaceLine& line) {
            return line.from == left->beginMm && line.to == left->endMm;
        });
        QVERIFY(whole);
        // It is no part of a picture that is saved, and no motion has it.
        const QImage with = window().volumeView().convergedImage();
        choice().setShown(false);
        QCOMPARE(window().volumeView().convergedImage(), with);
        choice().setShown(true);
        window().motionPlayer().play();
        QTRY_VERIFY(overlay().discs.empty() && !pane("planes.b").tubeCores().marks);
        window().motionPlayer().pause();
        QTRY_VERIFY(!overlay().discs.empty() && pane("planes.b").tubeCores().marks);
        window().motionPlayer().setAngle(0);
        waitUntilIdle();
    }

    void oneStepComparesWithoutIt() {
        const int number = heaviestFirst(*run()).front();
        choice().choose(number);
        tellsOf(number);
        const int steps = window().document().steps().index();
        const Document before = document();
        click("tubeCores.compare");
        QVERIFY(window().compareRoom().shown());
        QCOMPARE(window().document().steps().index(), steps + 1);
        QCOMPARE(document().panes.size(), 2u);
        QCOMPARE(document().panes[0].withoutTubes, std::vector<int>());
        QCOMPARE(document().panes[1].withoutTubes, std::vector<int>{number});
        window().document().steps().undo();
        QCOMPARE(document(), before);
        QTRY_VERIFY(!window().compareRoom().shown());
        child<QDockWidget>("dock.tubeCores")->raise();
        waitUntilIdle();
    }

    void whatThePanelTellsIsSavedAsAPage() {
        const int number = heaviestFirst(*run()).front();
        choice().choose(number);
        tellsOf(number);
        const QString path = temporaryFolder().filePath("core.html");
        window().tubeCorePage().save(path);
        waitUntilIdle();
        QFile file(path);
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QString page = QString::fromUtf8(file.readAll());
        QVERIFY2(page.contains(QString("ube core %1").arg(number)), qPrintable(page.left(2000)));
        QCOMPARE(page.count("data:image/png"), 3);
        QVERIFY(page.contains("fetus.mha"));
        for (const ExplanationFact& fact : window().tubeCoreExplaining().explanation()->facts)
            QVERIFY2(page.contains(QString::fromStdString(fact.value).toHtmlEscaped()), fact.value.c_str());
        const std::string light(nameOf(document().scene.look.lighting));
        QVERIFY2(page.contains(QString::fromStdString("<td>Light</td><td>" + light)), light.c_str());
    }

    void noPageIsSavedOfAnOlderCurve() {
        const int number = heaviestFirst(*run()).front();
        choice().choose(number);
        tellsOf(number);
        window().document().change("low reach", [](Document& next) { ++next.method.config.surface.lowReach; });
        const QString path = temporaryFolder().filePath("older.html");
        window().tubeCorePage().save(path);
        QCOMPARE(child<MessageBar>("message")->text(),
                 "The newest curve is not explained yet, so no page was saved. Try it again once it is.");
        tellsOf(number);
        waitUntilIdle();
        QVERIFY(!QFile::exists(path));
        window().tubeCorePage().save(path);
        waitUntilIdle();
        QVERIFY(QFile::exists(path));
        window().document().steps().undo();
        waitUntilIdle();
    }

    void theNoteSaysIfThePictureShowsAnotherCurve() {
        const auto* note = child<QLabel>("tubeCores.note");
        QVERIFY(note->isHidden());
        window().document().change("curve", [](Document& next) { next.panes[0].curve = CurveKind::parabolic; });
        QCOMPARE(note->text(), "The picture shows the parabolic curve. The panel explains the adaptive one.");
        window().document().steps().undo();
        QVERIFY(note->isHidden());
        window().document().change("designer", [](Document& next) { next.panes[0].designer = AdaptiveConfig{}; });
        QVERIFY2(note->isHidden(), "the designer's OTF is the adaptive one");
        window().document().steps().undo();
        waitUntilIdle();
    }

    void anotherStudyOrASmallerGridEndsTheChoice() {
        choice().choose(200);
        tellsOf(200);
        window().document().change("grid", [](Document& next) { next.method.config.grid.rows = 13; });
        QTRY_VERIFY(!choice().number());
        window().document().steps().undo();
        QTRY_COMPARE(run()->tubes.size(), 225u);
        choice().choose(112);
        tellsOf(112);
        open(m_other);
        QVERIFY(!choice().number());
        QVERIFY(!child("tubeCores.facts")->isVisible());
        QVERIFY(child<QLabel>("tubeCores.sentence")->text().startsWith("Click a tube core"));
    }

    void anotherStudyOpenedWhileThePanelIsHiddenLeavesNothingOfTheOneBefore() {
        const int number = heaviestFirst(*run()).front();
        choice().choose(number);
        tellsOf(number);
        const auto* picture = child<QLabel>("tubeCores.picture.all");
        QTRY_VERIFY(!picture->pixmap().isNull());
        waitUntilIdle();
        child<QDockWidget>("dock.tubeCores")->hide();
        const std::weak_ptr<const Volume> before = window().openStudy().study()->phases.front();
        QVERIFY(!before.expired());
        open(m_file);
        waitUntilIdle();
        QTRY_VERIFY(before.expired());
        QVERIFY(!window().tubeCoreExplaining().explanation());
        child<QDockWidget>("dock.tubeCores")->show();
        child<QDockWidget>("dock.tubeCores")->raise();
        QTRY_VERIFY(child("tubeCores")->isVisible());
        QVERIFY(!child("tubeCores.facts")->isVisible());
        QVERIFY(picture->pixmap().isNull());
        QVERIFY(child<QLabel>("tubeCores.sentence")->text().startsWith("Click a tube core"));
    }

private:
    TubeCoreChoice& choice() { return window().tubeCoreChoice(); }
    std::shared_ptr<const AdaptiveOtf> run() { return window().otfs().adaptive(); }
    const Overlay& overlay() { return window().volumeView().overlay(); }
    void clickIn3d(const QPoint& at) { QTest::mouseClick(pictureWindow(), Qt::LeftButton, {}, at); }

    QStringList factsShown() {
        const auto* facts = child<QTableWidget>("tubeCores.facts");
        QStringList shown;
        for (int row = 0; row < facts->rowCount(); ++row)
            shown << facts->item(row, 0)->text() + '=' + facts->item(row, 1)->text();
        return shown;
    }
    /// The panel tells of this tube core what explainTube() says of the voxels and the curve that the window has.
    void tellsOf(int number) {
        QCOMPARE(choice().number(), number);
        QTRY_VERIFY(window().tubeCoreExplaining().explanation() &&
                    window().tubeCoreExplaining().explanation()->explanation->number == number &&
                    window().tubeCoreExplaining().explanation()->run == run() &&
                    window().otfs().isNewest(PaneOtfs::adaptiveOfScene));
        const auto otf = window().otfs().of(PaneOtfs::adaptiveOfScene);
        QVERIFY(otf->asked.reduction == SpeckleReduction::off);
        const auto explanation = explainTube(*otf->asked.raw, {}, *run(), number);
        QStringList expected;
        for (const ExplanationFact& fact : explanationFacts(*explanation)) {
            const QString value = QString::fromStdString(fact.value), unit = QString::fromStdString(fact.unit);
            expected << QString::fromStdString(fact.symbol) + '=' + (unit.isEmpty() ? value : value + ' ' + unit);
        }
        QCOMPARE(factsShown(), expected);
        QCOMPARE(child<QLabel>("tubeCores.sentence")->text(),
                 QString::fromStdString(explanationSentence(*explanation)));
        const auto* facts = child<QTableWidget>("tubeCores.facts");
        QVERIFY(facts->isVisible() && !facts->item(0, 0)->toolTip().isEmpty());
    }

    QString m_file, m_other;
};

ECHOLUCENT_TEST_CLASS(TestTubeCores)
#include "test_tube_cores.moc"
