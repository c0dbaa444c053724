// The near cut that the program suggests: what it does, what it says, and the way back.
#include <QAbstractSpinBox>
#include <QLocale>
#include <QThread>
#include <new>

#include "app/otf/near_cut_finder.h"
#include "tests/app/window_fixture.h"
#include "tests/qt_program/test_classes.h"
#include "widgets/controls/message_bar.h"

using namespace echolucent;

namespace {

NearCutFinder::Search found(const NearCutFinding& finding) {
    return [finding](const Volume&, const Viewpoint&, const Progress&) { return std::optional(finding); };
}

NearCutFinding wallBeforeFluid(double cutMm) {
    return {.answer = NearCutAnswer::wallBeforeFluid, .nearCutMm = cutMm, .message = "A wall stands before the fluid."};
}

NearCutFinding fluidAtFront() {
    return {.answer = NearCutAnswer::fluidAtFront, .message = "The fluid begins at the front."};
}

}  // namespace

class TestMainWindowNearCut : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        m_fixture.lookAlongAssumedBeam();
        QLocale::setDefault(QLocale::c());
        m_fixture.lookAtNoPicture();
        m_file = m_fixture.file("still.mha", {smallPhantom(PhantomScene::shapes, 5)});
    }
    void init() {
        m_fixture.show();
        m_fixture.open(m_file);
    }
    void cleanup() { m_fixture.close(); }

    void theSuggestedCutIsMadeSaidAndTakenBack() {
        m_fixture.window().nearCutFinder().setSearch(found(wallBeforeFluid(18.04)));
        m_fixture.click("view.nearCut.suggest");
        QTRY_VERIFY(message()->isVisible());
        QCOMPARE(message()->text(), "A wall stands before the fluid.");
        m_fixture.waitUntilIdle();
        QCOMPARE(frontDepthMm(m_fixture.window().volumeView().view()), 18.0);
        QCOMPARE(frontDepthMm(m_fixture.window().otfs().adaptive()->view), 18.0);
        QCOMPARE(m_fixture.child<QAbstractSpinBox>("view.nearCut.value")->text(), "18.0 mm");

        m_fixture.click("message.action.0");
        m_fixture.waitUntilIdle();
        QCOMPARE(frontDepthMm(m_fixture.window().volumeView().view()), 0.0);
        QCOMPARE(frontDepthMm(m_fixture.window().otfs().adaptive()->view), 0.0);
        QCOMPARE(m_fixture.child<QAbstractSpinBox>("view.nearCut.value")->text(), "0.0 mm");
    }

    void theWayBackUndoesTheStepWhileItIsTheNewest() {
        const auto wayBack = [this] { return m_fixture.child<QAbstractButton>("message.action.0")->text(); };
        DocumentSteps& steps = m_fixture.window().document().steps();
        m_fixture.window().nearCutFinder().setSearch(found(wallBeforeFluid(18)));
        lookFrom(m_fixture.window(), {.azimuthDegrees = 20});
        const Document before = m_fixture.window().document().document();
        const int index = steps.index();
        m_fixture.click("view.nearCut.suggest");
        QTRY_VERIFY(message()->isVisible());
        QCOMPARE(wayBack(), "Undo");
        QCOMPARE(steps.index(), index + 1);
        m_fixture.click("message.action.0");
        QVERIFY(m_fixture.window().document().document() == before);  // tube cores look as before too
        QCOMPARE(steps.index(), index);
        QVERIFY(steps.canRedo());

        // After another step an undo would be of that one.
        m_fixture.click("view.nearCut.suggest");
        QTRY_VERIFY(message()->isVisible());
        lookFrom(m_fixture.window(), {.azimuthDegrees = 25});
        QCOMPARE(wayBack(), "No front");
        steps.undo();
        QCOMPARE(wayBack(), "Undo");
        steps.redo();
        m_fixture.click("message.action.0");
        QVERIFY(front() == Front{});
        QCOMPARE(m_fixture.window().document().document().scene.pose.direction.azimuth, 25.0);
        QCOMPARE(steps.index(), index + 3);
        QCOMPARE(steps.undoText(), "front");

        steps.undo();
        m_fixture.window().nearCutFinder().setSearch(found(wallBeforeFluid(12)));
        m_fixture.click("view.nearCut.suggest");
        QTRY_COMPARE(front().depthMm, 12.0);
        lookFrom(m_fixture.window(), {.azimuthDegrees = 30});
        QCOMPARE(wayBack(), "The front before");
        m_fixture.click("message.action.0");
        QCOMPARE(front().depthMm, 18.0);
        m_fixture.waitUntilIdle();
    }

    void theWayBackTurnsNoTubeCores() {
        m_fixture.window().nearCutFinder().setSearch(found(wallBeforeFluid(18)));
        lookFrom(m_fixture.window(), {.azimuthDegrees = 20});
        m_fixture.click("view.nearCut.suggest");
        QTRY_VERIFY(message()->isVisible());
        lookFrom(m_fixture.window(), {.azimuthDegrees = 35});
        QTest::keyClick(&m_fixture.window(), Qt::Key_A);
        m_fixture.waitUntilIdle();
        QTest::keyClick(&m_fixture.window(), Qt::Key_N, Qt::ShiftModifier);
        m_fixture.waitUntilIdle();
        QCOMPARE(frontDepthMm(m_fixture.window().otfs().adaptive()->view), 0.0);
        QCOMPARE(m_fixture.window().otfs().adaptive()->view.azimuthDegrees, 35.0);
    }

    void itIsLookedForInTheViewOfTheCamera() {
        std::optional<Viewpoint> view;
        QThread* thread = nullptr;
        m_fixture.window().nearCutFinder().setSearch([&](const Volume&, const Viewpoint& asked, const Progress&) {
            view = asked;
            thread = QThread::currentThread();
            return std::optional(wallBeforeFluid(5));
        });
        Viewpoint turned;
        turned.azimuthDegrees = 20;
        lookFrom(m_fixture.window(), turned);
        m_fixture.waitUntilIdle();
        m_fixture.click("view.nearCut.suggest");
        QTRY_COMPARE(frontDepthMm(m_fixture.window().volumeView().view()), 5.0);
        m_fixture.waitUntilIdle();
        QCOMPARE(view->azimuthDegrees, 20.0);
        QVERIFY(thread != QThread::currentThread());
        QCOMPARE(m_fixture.window().otfs().adaptive()->view.azimuthDegrees, 20.0);
        QCOMPARE(frontDepthMm(m_fixture.window().otfs().adaptive()->view), 5.0);
    }

    void aCurvedFrontIsOfferedWhereThereIsOne() {
        NearCutFinding curved = wallBeforeFluid(18);
        curved.surface = CutSurface{.frame = frameOf(Viewpoint{}),
                                    .firstRightMm = 0,
                                    .firstDownMm = 0,
                                    .spacingMm = 30,
                                    .columns = 2,
                                    .rows = 2,
                                    .depthMm = {16, 20, 16, 20}};
        m_fixture.window().nearCutFinder().setSearch(found(curved));
        m_fixture.click("view.nearCut.suggest");
        QTRY_VERIFY(message()->isVisible());
        m_fixture.click("message.action.0");
        m_fixture.waitUntilIdle();
        QVERIFY(m_fixture.window().document().document().scene.front == Front{.surface = curved.surface});
        QVERIFY(m_fixture.window().otfs().adaptive()->view.cutSurface == curved.surface);
        QVERIFY(m_fixture.window().volumeView().caption().contains("front, bowed"));
        QTest::keyClick(&m_fixture.window(), Qt::Key_N, Qt::ShiftModifier);
        m_fixture.waitUntilIdle();
        QVERIFY(m_fixture.window().document().document().scene.front == Front{});
    }

    void itsTiltFollowsTheViewOnlyIfAsked() {
        m_fixture.window().nearCutFinder().setSearch(found(wallBeforeFluid(18)));
        QTest::keyClick(&m_fixture.window(), Qt::Key_N);
        QTRY_COMPARE(front().depthMm, 18.0);
        QVERIFY(front().direction == ViewDirection{});
        lookFrom(m_fixture.window(), {.azimuthDegrees = 30});
        QVERIFY(front().direction == ViewDirection{});
        m_fixture.child<QAbstractSpinBox>("view.nearCut.value")->stepUp();
        QVERIFY(front().direction == ViewDirection{});
        const double deeper = front().depthMm;
        QVERIFY(deeper > 18.0);
        QTest::keyClick(&m_fixture.window(), Qt::Key_N);
        QVERIFY((front().direction == ViewDirection{.azimuth = 30}));
        QVERIFY(front().depthMm > 0.0);
        QTest::keyClick(&m_fixture.window(), Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(front() == frontAcross({}, deeper));
        QTest::keyClick(&m_fixture.window(), Qt::Key_N, Qt::ShiftModifier);
        QVERIFY(front() == Front{});
        m_fixture.waitUntilIdle();
    }

    void theSliderMakesAFrontAcrossTheViewIfThereIsNone() {
        lookFrom(m_fixture.window(), {.azimuthDegrees = 25, .elevationDegrees = 10});
        m_fixture.child<QAbstractSpinBox>("view.nearCut.value")->stepUp();
        QVERIFY((front().direction == ViewDirection{.azimuth = 25, .elevation = 10}));
        m_fixture.waitUntilIdle();
    }

    void whyNotIsSaidAndNothingChanges() {
        m_fixture.window().nearCutFinder().setSearch(
            found({.answer = NearCutAnswer::noFluid, .message = "No fluid was found."}));
        m_fixture.click("view.nearCut.suggest");
        QTRY_VERIFY(message()->isVisible());
        QCOMPARE(message()->text(), "No fluid was found.");
        QCOMPARE(message()->kind(), MessageKind::warning);
        m_fixture.waitUntilIdle();
        QCOMPARE(frontDepthMm(m_fixture.window().volumeView().view()), 0.0);
        QVERIFY(m_fixture.window().otfs().adaptive() != nullptr);
    }

    void nothingInFrontNeedsNoCut() {
        m_fixture.window().nearCutFinder().setSearch(found(fluidAtFront()));
        m_fixture.click("view.nearCut.suggest");
        QTRY_COMPARE(message()->text(), "The fluid begins at the front.");
    }

    void noCutTurnsNoTubeCores() {
        m_fixture.window().nearCutFinder().setSearch(found(fluidAtFront()));
        lookFrom(m_fixture.window(), {.azimuthDegrees = 20});
        m_fixture.waitUntilIdle();
        m_fixture.click("view.nearCut.suggest");
        QTRY_COMPARE(message()->text(), "The fluid begins at the front.");
        m_fixture.waitUntilIdle();
        QCOMPARE(m_fixture.window().otfs().adaptive()->view.azimuthDegrees, 0.0);
    }

    void theSearchOfTheProgramAgreesWithThePureFunction() {
        const auto expected = findNearCut(*m_fixture.window().openStudy().volume(), Viewpoint{});
        m_fixture.click("view.nearCut.suggest");
        QTRY_VERIFY(message()->isVisible());
        m_fixture.waitUntilIdle();
        const double cut = frontDepthMm(m_fixture.window().volumeView().view());
        QVERIFY(qAbs(cut - expected->nearCutMm) <= 0.05 + 1e-9);
    }

    void aMessageThatIsNoLongerTrueGoes() {
        m_fixture.window().nearCutFinder().setSearch(found(wallBeforeFluid(18)));
        m_fixture.click("view.nearCut.suggest");
        QTRY_VERIFY(message()->isVisible());
        m_fixture.waitUntilIdle();
        QTest::keyClick(&m_fixture.window(), Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(!message()->isVisible());
        m_fixture.waitUntilIdle();
        m_fixture.click("view.nearCut.suggest");
        QTRY_VERIFY(message()->isVisible());
        message()->setRemark("The volume is dark.");
        auto* value = m_fixture.child<QAbstractSpinBox>("view.nearCut.value");
        value->stepDown();
        QCOMPARE(message()->text(), "The volume is dark.");
        QVERIFY(m_fixture.window().findChild<QWidget*>("message.action.0") == nullptr);
        m_fixture.waitUntilIdle();
    }

    void aMessageDoesNotStayOverPicturesOfOtherFronts() {
        const auto suggest = [this](const NearCutFinding& finding) {
            m_fixture.window().nearCutFinder().setSearch(found(finding));
            m_fixture.click("view.nearCut.suggest");
            QTRY_VERIFY(message()->isVisible());
            m_fixture.waitUntilIdle();
            QVERIFY(message()->isVisible());
        };
        // The front stays in the body: seen from elsewhere it is the same.
        suggest(wallBeforeFluid(18));
        QCOMPARE(message()->kind(), MessageKind::info);
        lookFrom(m_fixture.window(), {.azimuthDegrees = 35});
        m_fixture.window().motionPlayer().setAngle(7);
        QVERIFY(message()->isVisible());
        QTest::keyClick(&m_fixture.window(), Qt::Key_N);
        QVERIFY(!message()->isVisible());
        // Moved and magnified it is the same.
        suggest(wallBeforeFluid(14));
        Document next = m_fixture.window().document().document();
        next.scene.pose.magnification = 2;
        m_fixture.window().document().edit(next, "zoom");
        QVERIFY(message()->isVisible());
        m_fixture.waitUntilIdle();
    }

    void theWayBackKeepsTheViewOfAFrame() {
        m_fixture.window().nearCutFinder().setSearch(found(wallBeforeFluid(18)));
        m_fixture.click("motion.mode.eachView");
        m_fixture.waitUntilIdle();
        m_fixture.click("view.nearCut.suggest");
        QTRY_VERIFY(message()->isVisible());
        m_fixture.waitUntilIdle();
        m_fixture.window().motionPlayer().setAngle(7);
        m_fixture.waitUntilIdle();
        QCOMPARE(m_fixture.window().otfs().adaptive()->view.azimuthDegrees, 7.0);
        QTest::keyClick(&m_fixture.window(), Qt::Key_N, Qt::ShiftModifier);
        m_fixture.waitUntilIdle();
        QCOMPARE(frontDepthMm(m_fixture.window().otfs().adaptive()->view), 0.0);
        QCOMPARE(m_fixture.window().otfs().adaptive()->view.azimuthDegrees, 7.0);
    }

    void aSearchThatFailsLosesNoOtf() {
        m_fixture.window().nearCutFinder().setSearch(
            [](const Volume&, const Viewpoint&, const Progress&) -> std::optional<NearCutFinding> {
                throw std::bad_alloc();
            });
        lookFrom(m_fixture.window(), {.azimuthDegrees = 20});
        QTest::keyClick(&m_fixture.window(), Qt::Key_A);
        QVERIFY(m_fixture.window().otfs().busy());
        m_fixture.click("view.nearCut.suggest");
        QTRY_VERIFY(message()->isVisible());
        QVERIFY(message()->text().contains("needs more memory"));
        m_fixture.waitUntilIdle();
        QCOMPARE(m_fixture.window().otfs().adaptive()->view.azimuthDegrees, 20.0);
    }

    void anOtfIsComputedWhileASearchGoesOnAndCancelEndsIt() {
        m_fixture.window().nearCutFinder().setSearch([](const Volume&, const Viewpoint&, const Progress& progress) {
            while (!progress.cancelled()) QThread::yieldCurrentThread();
            return std::optional<NearCutFinding>();
        });
        lookFrom(m_fixture.window(), {.azimuthDegrees = 20});
        m_fixture.click("view.nearCut.suggest");
        QVERIFY(m_fixture.window().nearCutFinder().busy());
        QTest::keyClick(&m_fixture.window(), Qt::Key_A);
        QTRY_COMPARE(m_fixture.window().otfs().adaptive()->view.azimuthDegrees, 20.0);
        QVERIFY(!m_fixture.window().idle());
        m_fixture.click("status.cancel");
        m_fixture.waitUntilIdle();
        QCOMPARE(m_fixture.window().otfs().adaptive()->view.azimuthDegrees, 20.0);
        QVERIFY(!message()->isVisible());
    }

private:
    const Front& front() { return m_fixture.window().document().document().scene.front; }
    MessageBar* message() { return m_fixture.child<MessageBar>("message"); }

    WindowFixture m_fixture;
    QString m_file;
};

ECHOLUCENT_TEST_CLASS(TestMainWindowNearCut)

#include "test_main_window_near_cut.moc"
