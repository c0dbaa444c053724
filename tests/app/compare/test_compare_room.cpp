// The comparison in the real window: panes under one camera, what the hand does there, the table, undo and sessions.
#include <QAction>
#include <QClipboard>
#include <QDockWidget>
#include <QLabel>
#include <QSpinBox>
#include <QTableWidget>
#include <QWheelEvent>

#include "app/sessions/session_keeping.h"
#include "io/document/session_file.h"
#include "processing/adaptive/method_reading.h"
#include "processing/pane_picture/pane_measures.h"
#include "tests/app/compare/compare_fixture.h"
#include "tests/qt_program/test_classes.h"

using namespace echolucent;

class TestCompareRoom : public QObject, private CompareFixture {
    Q_OBJECT

private slots:
    void initTestCase() { makeFiles(); }
    void init() { begin(); }
    void cleanup() { close(); }

    void theKeyShowsFourPanesAndTakesThemAway() {
        QVERIFY(grid().isVisible());
        QVERIFY(!window().volumeView().isVisible());
        QCOMPARE(document().panes.size(), std::size_t{4});
        QVERIFY(child<QDockWidget>("dock.compare")->isVisible());
        QTest::keyClick(&window(), Qt::Key_F5);
        QTRY_VERIFY(window().volumeView().isVisible());
        QVERIFY(!grid().isVisible());
        QTest::keyClick(&window(), Qt::Key_F5);
        QTRY_VERIFY(grid().isVisible());
        child<QAction>("room.quad")->trigger();
        QTRY_VERIFY(!grid().isVisible());
    }

    void allPanesAreCastWithOneCameraAndTheirOwnOtf() {
        const auto frame = window().compareRoom().views().frame();
        QVERIFY(frame->converged());
        QCOMPARE(frame->panes.size(), std::size_t{4});
        for (std::size_t i = 0; i < 4; ++i) {
            QCOMPARE(images()[i].size(), images()[0].size());
            QVERIFY(frame->request.panes[i].volume == window().openStudy().newestVoxels());
            QVERIFY(grid().pane(i).image() == images()[i]);
            for (std::size_t k = 0; k < i; ++k) QVERIFY(images()[i] != images()[k]);
        }
        QVERIFY(frame->request.panes[3].classification.isTwoDimensional());
        QVERIFY(window().idle());
    }

    void aDragOrbitsAllPanesInOneStep() {
        const Pose before = document().scene.pose;
        const auto frameBefore = window().compareRoom().views().frame();
        const std::vector<QImage> imagesBefore = images();
        const int steps = window().document().steps().index();
        ComparePane& pane = grid().pane(2);
        drag(pane, pane.pictureRect().center(), QPoint(40, 15), Qt::LeftButton);
        QVERIFY(document().scene.pose.direction != before.direction);
        QCOMPARE(window().document().steps().index(), steps + 1);
        waitForFrame();
        const auto frame = window().compareRoom().views().frame();
        QVERIFY(frame->settings.camera != frameBefore->settings.camera);
        for (std::size_t i = 0; i < 4; ++i) QVERIFY(images()[i] != imagesBefore[i]);
        window().document().steps().undo();
        QVERIFY(document().scene.pose == before);
        waitForFrame();
        QVERIFY(window().compareRoom().views().frame()->settings.camera == frameBefore->settings.camera);
        for (std::size_t i = 0; i < 4; ++i) QCOMPARE(images()[i].size(), imagesBefore[i].size());
    }

    void escapeEndsADragWithoutChange() {
        const Document before = document();
        const int steps = window().document().steps().index();
        ComparePane& pane = grid().pane(0);
        const QPoint from = pane.pictureRect().center();
        QTest::mousePress(&pane, Qt::LeftButton, {}, from);
        QTest::mouseMove(&pane, from + QPoint(30, 0));
        sendMove(pane, from + QPoint(30, 0), Qt::LeftButton);
        QVERIFY(document() != before);
        QTest::keyClick(&pane, Qt::Key_Escape);
        QVERIFY(document() == before);
        QTest::mouseRelease(&pane, Qt::LeftButton, {}, from + QPoint(30, 0));
        QCOMPARE(window().document().steps().index(), steps);
    }

    void otherDragsPanZoomAndMoveTheLight() {
        ComparePane& pane = grid().pane(1);
        const Pose before = document().scene.pose;
        drag(pane, pane.pictureRect().center(), QPoint(20, 10), Qt::MiddleButton);
        QVERIFY(document().scene.pose.offsetMm != before.offsetMm);
        QVERIFY(document().scene.pose.direction == before.direction);
        drag(pane, pane.pictureRect().center(), QPoint(0, 30), Qt::RightButton);
        QVERIFY(document().scene.pose.magnification < before.magnification);
        Document lit = document();
        lit.scene.look.lighting = Lighting::surface;
        window().document().edit(lit, "light");
        const LightDirection light = document().scene.look.light;
        drag(pane, pane.pictureRect().center(), QPoint(25, 0), Qt::LeftButton, Qt::ControlModifier);
        QVERIFY(document().scene.look.light != light);
        const double magnification = document().scene.pose.magnification;
        QWheelEvent wheel(pane.pictureRect().center(), pane.mapToGlobal(pane.pictureRect().center()), {}, {0, 120},
                          Qt::NoButton, {}, Qt::NoScrollPhase, false);
        QApplication::sendEvent(&pane, &wheel);
        QVERIFY(document().scene.pose.magnification > magnification);
    }

    void aDoubleClickMaximisesAndEscapeGivesBack() {
        QTest::mouseDClick(&grid().pane(1), Qt::LeftButton, {}, grid().pane(1).pictureRect().center());
        QTRY_COMPARE(grid().maximised(), std::optional<std::size_t>(1));
        QVERIFY(!grid().pane(0).isVisible());
        waitForFrame();
        QCOMPARE(window().compareRoom().views().frame()->panes.size(), std::size_t{1});
        QTest::keyClick(&grid().pane(1), Qt::Key_Escape);
        QVERIFY(!grid().maximised());
        QVERIFY(grid().pane(0).isVisible());
    }

    void aPaneIsChosenInOneStepThatCanBeTakenBack() {
        const int steps = window().document().steps().index();
        auto* otf = child<QComboBox>("compare.otf2");
        const int otsu = otf->findText("Otsu", Qt::MatchStartsWith);
        QVERIFY(otsu > 0);
        choose(otf, otsu);
        QCOMPARE(window().document().steps().index(), steps + 1);
        QVERIFY(designerConfigOf(document(), 1) != nullptr);
        QVERIFY(*designerConfigOf(document(), 1) == DesignerConfig(OtsuConfig{}));
        waitForFrame();
        window().document().steps().undo();
        QVERIFY(designerConfigOf(document(), 1) == nullptr);
        QCOMPARE(document().panes.at(1).curve, CurveKind::parabolic);
        child<QSpinBox>("compare.count")->setValue(2);
        QCOMPARE(document().panes.size(), std::size_t{2});
        waitForFrame();
        window().document().steps().undo();
        QCOMPARE(document().panes.size(), std::size_t{4});
        QVERIFY(designerConfigOf(document(), 3) != nullptr);
    }

    void aTubeCoreIsLeftOutOfOnePane() {
        auto* otf = child<QComboBox>("compare.otf3");
        choose(otf, otf->count() - 1);
        QCOMPARE(document().panes.at(2).withoutTubes.size(), std::size_t{1});
        child<QSpinBox>("compare.tube3")->setValue(97);
        QCOMPARE(document().panes.at(2).withoutTubes, std::vector{97});
        waitForFrame();
        QVERIFY(grid().pane(2).face().name.contains("97"));
    }

    void theTableEqualsTheMeasures() {
        QTRY_VERIFY_WITH_TIMEOUT(panel().rows().size() == 4 && panel().rows()[3].contrast, 30000);
        expectRowsAreMeasured();
        QCOMPARE(child<QTableWidget>("compare.table")->item(2, 0)->text(), cellsOf(panel().rows()[2])[1]);
        click("compare.copyCsv");
        QCOMPARE(QApplication::clipboard()->text(), compareCsv(panel().rows()));
        click("compare.copyText");
        QCOMPARE(QApplication::clipboard()->text(), compareText(panel().rows()));
        QVERIFY(grid().pane(0).face().numbers.startsWith("right "));
        QCOMPARE(grid().pane(0).face().numbers, numbersOf(panel().rows()[0]));
        QVERIFY(panel().rows()[0].surfaces == SurfacesFrom::tubeCores);
        QVERIFY(child<QLabel>("compare.note")->text().contains("tube cores find"));
        QVERIFY(panel().rows()[0].designMilliseconds && panel().rows()[3].designMilliseconds);
        QVERIFY(!panel().rows()[1].designMilliseconds);  // a curve is not designed
    }

    void theNumbersFollowTheViewAndNoReadingOfTheMethod() {
        QTRY_VERIFY_WITH_TIMEOUT(panel().rows().size() == 4 && panel().rows()[3].contrast, 30000);
        const auto before = panel().rows();
        Document next = document();
        next.method.config = configOf(MethodReading::asPublished);
        window().document().edit(next, "reading");
        waitUntilRest();
        QTRY_VERIFY_WITH_TIMEOUT(panel().rows()[0].contrast && panel().rows()[0].contrast != before[0].contrast, 30000);
        for (const std::size_t fixed : {1u, 2u}) {
            QVERIFY(panel().rows()[fixed].depth == before[fixed].depth);
            QVERIFY(panel().rows()[fixed].contrast == before[fixed].contrast);
            QVERIFY(panel().rows()[fixed].nearSurfaces == before[fixed].nearSurfaces);
        }
        next.scene.motionAngle = 35;
        window().document().edit(next, "angle");
        QVERIFY(viewpointOf(document()) != otfViewpointOf(document(), firstPane));
        waitUntilRest();
        QTRY_VERIFY_WITH_TIMEOUT(panel().rows()[1].depth && panel().rows()[1].depth != before[1].depth, 30000);
        expectRowsAreMeasured();
    }

    void flickerIsMeasuredOnRequest() {
        waitUntilRest();
        QVERIFY(!panel().rows()[0].flicker);
        click("compare.measureFlicker");
        QVERIFY(!window().idle());
        QTRY_VERIFY_WITH_TIMEOUT(panel().rows()[0].flicker.has_value(), 60000);
        QVERIFY(*panel().rows()[0].flicker > 0.0);
        QCOMPARE(*panel().rows()[1].flicker, 0.0);
        QVERIFY(*panel().rows()[3].flicker > 0.0);  // Levoy's levels follow the tube cores
        // Of another axis it is another one.
        Document next = document();
        next.motion.axis = MotionAxis::x;
        window().document().edit(next, "axis");
        QTRY_VERIFY(!panel().rows()[0].flicker);
    }

    void aDifferenceAndAWipeShowTwoPanes() {
        auto* layout = child<QComboBox>("compare.layout");
        choose(layout, 1);
        QCOMPARE(document().comparison.layout, ComparisonLayout::difference);
        waitForFrame();
        QVERIFY(grid().pair().isVisible());
        QVERIFY(grid().pair().face().numbers.startsWith("RMSE"));
        const QImage before = grid().pair().image();
        QVERIFY(!before.isNull());
        choose(child<QComboBox>("compare.second"), 2);
        QCOMPARE(document().comparison.second, 2);
        waitForFrame();
        QVERIFY(grid().pair().image() != before);
        choose(layout, 2);
        waitForFrame();
        ComparePane& pair = grid().pair();
        const QRect picture = pair.pictureRect();
        const int steps = window().document().steps().index();
        const Pose pose = document().scene.pose;
        drag(pair, QPoint(picture.x() + picture.width() / 2, picture.center().y() - 30), QPoint(60, 0), Qt::LeftButton);
        QVERIFY(document().comparison.wipe > 0.5);
        QVERIFY(document().scene.pose == pose);
        QCOMPARE(window().document().steps().index(), steps + 1);
        const double wipe = document().comparison.wipe;
        const QPoint leftOfTheLine(picture.x() + picture.width() / 4, picture.center().y());
        const QRgb unfocused = pair.grab().toImage().pixel(leftOfTheLine * pair.devicePixelRatioF());
        pair.setFocus();
        QCOMPARE(pair.grab().toImage().pixel(leftOfTheLine * pair.devicePixelRatioF()), unfocused);
        QTest::keyClick(&pair, Qt::Key_Left);
        QVERIFY(document().comparison.wipe < wipe);
    }

    void lookingAtTheComparisonChangesNothingThatIsKept() {
        QTest::keyClick(&window(), Qt::Key_F5);
        waitUntilRest();
        const Document before = document();
        QCOMPARE(before.panes.size(), std::size_t{1});
        const int steps = window().document().steps().count();
        const auto& autosave = window().sessionKeeping().autosave();
        const bool kept = autosave.keeps();
        QTest::keyClick(&window(), Qt::Key_F5);
        QCOMPARE(document().panes.size(), std::size_t{4});
        QCOMPARE(window().document().ownDocument(), before);
        waitForFrame();
        QTRY_VERIFY(window().sessionKeeping().atRest());
        QVERIFY(!window().isWindowModified());
        QCOMPARE(autosave.keeps(), kept);
        QTest::keyClick(&window(), Qt::Key_F5);
        QCOMPARE(document(), before);
        QCOMPARE(window().document().steps().count(), steps);
        QTRY_VERIFY(window().sessionKeeping().atRest());
        QVERIFY(!window().isWindowModified());
    }

    void aStepFromBeforeIsTakenBackInTheRoom() {
        QTest::keyClick(&window(), Qt::Key_F5);
        lookFrom(window(), Viewpoint{.azimuthDegrees = 30});
        const Document turned = document();
        QTest::keyClick(&window(), Qt::Key_F5);
        QTest::keyClick(&window(), Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(document().scene.pose != turned.scene.pose);
        QCOMPARE(document().panes.size(), std::size_t{4});
        QVERIFY(window().compareRoom().shown());
        QTest::keyClick(&window(), Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
        QTest::keyClick(&window(), Qt::Key_F5);
        QCOMPARE(document(), turned);
        waitUntilRest();
    }

    void whatIsChosenInTheRoomIsKept() {
        choose(child<QComboBox>("compare.otf2"),
               child<QComboBox>("compare.otf2")->findText("Otsu", Qt::MatchStartsWith));
        const Document chosen = document();
        QTRY_VERIFY(window().isWindowModified());
        QTest::keyClick(&window(), Qt::Key_F5);
        QCOMPARE(document(), chosen);
        waitUntilRest();
    }

    void whatIsTakenBackLeavesTheRoom() {
        QTest::keyClick(&window(), Qt::Key_F5);
        child<QAction>("compare.motions")->trigger();
        QVERIFY(window().compareRoom().shown());
        waitUntilRest();
        window().document().steps().setIndex(0);
        QTRY_VERIFY(window().volumeView().isVisible());
        QVERIFY(!window().compareRoom().shown());
        QVERIFY(grid().pane(0).image().isNull());
    }

    void anotherStudyIsNotShownUnderTheOldPictures() {
        waitUntilRest();
        window().open(m_moving);
        QSignalSpy opened(&window().openStudy(), &OpenStudy::studyOpened);
        QVERIFY(opened.wait(patience));
        QVERIFY(!window().compareRoom().views().settled());
        waitUntilRest();
        QVERIFY(window().compareRoom().views().settled());
        QVERIFY(window().compareRoom().views().frame()->request.panes[0].volume == window().openStudy().newestVoxels());
    }

    void thePaneOfTheMainViewKeepsItsDesigner() {
        QTest::keyClick(&window(), Qt::Key_F5);
        Document next = withDesigner(document(), firstPane, OtsuConfig{.opacity = 0.5});
        next.panes.resize(1);
        window().document().begin(next);
        QTest::keyClick(&window(), Qt::Key_F5);
        QCOMPARE(std::get<OtsuConfig>(*designerConfigOf(document(), firstPane)).opacity, 0.5);
        QCOMPARE(document().panes.size(), std::size_t{4});
        waitForFrame();
    }

    void aSessionKeepsTheComparison() {
        Document next = document();
        next.comparison.layout = ComparisonLayout::wipe;
        next.comparison.first = 3;
        next.comparison.wipe = 0.3;
        window().document().edit(next, "wipe");
        const auto read = sessionFromJson(jsonOf(SavedSession{.document = document()}), "session");
        QVERIFY(read.has_value());
        QVERIFY(read->document == document());
        QCOMPARE(QByteArray::fromStdString(jsonOf(read->document)), QByteArray::fromStdString(jsonOf(document())));
    }

    void aPaneShowsAnotherPhase() {
        window().open(m_moving);
        waitUntilRest();
        waitForFrame();
        QVERIFY(child<QSpinBox>("compare.phase2")->isVisible());
        child<QSpinBox>("compare.phase2")->setValue(2);
        QCOMPARE(phaseOf(document(), 1), 1);
        QCOMPARE(phaseOf(document(), firstPane), 0);
        waitForFrame();
        const auto frame = window().compareRoom().views().frame();
        QVERIFY(frame->request.panes[1].volume != frame->request.panes[0].volume);
        QVERIFY(frame->request.panes[2].volume == frame->request.panes[0].volume);
        QTRY_VERIFY_WITH_TIMEOUT(panel().rows().size() == 4 && panel().rows()[1].depth, 30000);
        expectRowsAreMeasured();
        window().document().steps().undo();
        QCOMPARE(phaseOf(document(), 2), 0);
        window().document().steps().redo();
        QCOMPARE(phaseOf(document(), 1), 1);
    }

    void theFullScreenShowsThePanesAlone() {
        QTest::keyClick(&window(), Qt::Key_F);
        QTRY_VERIFY(!child<QDockWidget>("dock.compare")->isVisible());
        QVERIFY(grid().isVisible());
        QTest::keyClick(&window(), Qt::Key_Escape);
        QTRY_VERIFY(child<QDockWidget>("dock.compare")->isVisible());
    }

private:
    /// The table says what the command line measures of the document (`echolucent-cli compare`).
    void expectRowsAreMeasured() {
        const auto measured = measuresOfPanes(document(), {.scans = window().openStudy().study()->phases});
        for (std::size_t i = 0; i < 4; ++i) {
            const CompareRow& row = panel().rows()[i];
            QVERIFY((*measured)[i].has_value());
            QVERIFY(row.surfaces == (*measured)[i]->from);
            QVERIFY(row.depth == (*measured)[i]->measures.depth);
            QVERIFY(row.contrast == (*measured)[i]->measures.contrast.contrastToNoise());
            QVERIFY(row.nearSurfaces == (*measured)[i]->measures.light.meanShare);
        }
    }
};

ECHOLUCENT_TEST_CLASS(TestCompareRoom)

#include "test_compare_room.moc"
