// The six sides in the real main window: opening, strip, keys, caption, what is remembered.
#include <QToolButton>
#include <algorithm>
#include <set>

#include "app/otf/near_cut_finder.h"
#include "app/picture/side_controls.h"
#include "app/settings/settings.h"
#include "processing/document/opening_finds.h"
#include "processing/document/side_taking.h"
#include "tests/app/window_fixture.h"
#include "tests/processing/sides/hill.h"

using namespace echolucent;

class TestSides : public QObject, private WindowFixture {
    Q_OBJECT

private slots:
    void initTestCase() {
        QLocale::setDefault(QLocale::c());
        seeSides();
        // Only side 4 shows the hill, and side 3 its back.
        m_file = file("hill.mha", {std::make_shared<const Volume>(hillSeenAlong({0, 1, 0}))});
    }
    void init() {
        show();
        open(m_file);
    }
    void cleanup() { close(); }

    void aScanOpensFromTheSideThatShowsMostBehindItsFront() {
        const OpeningFinds& finds = *window().openStudy().finds();
        QCOMPARE(finds.source, SideSource::found);
        const JudgedSide& best = finds.sides->sides[finds.sides->best];
        QCOMPARE(frameOf(best.side.view).forward, Vec3(0, 1, 0));
        QCOMPARE(frameOf(viewpointOf(document())).forward, Vec3(0, 1, 0));
        QVERIFY(document().scene.front == frontOf(best.side.view, best.front));
        QVERIFY(cuts(document().scene.front));
        QCOMPARE(takenInStrip(), static_cast<int>(finds.sides->best) + 1);
        QVERIFY2(window().volumeView().caption().startsWith(QStringLiteral("side %1").arg(takenInStrip())),
                 qPrintable(window().volumeView().caption()));
    }

    void theMessageOfAFrontFoundOnOpeningOffersNone() {
        window().nearCutFinder().tellOpening(*window().openStudy().finds()->cut);
        QAbstractButton* none = nullptr;
        for (auto* button : child<MessageBar>("message")->findChildren<QAbstractButton*>()) {
            QVERIFY(button->text() != "Undo");  // that would take beam and side back too
            if (button->text() == "No front") none = button;
        }
        QVERIFY(none != nullptr);
        const Document opened = document();
        const int steps = window().document().steps().index();
        none->click();
        QVERIFY(!cuts(document().scene.front));
        QVERIFY(document().scene.side == opened.scene.side);
        QCOMPARE(window().document().steps().index(), steps + 1);
        waitUntilIdle();
    }

    void keysAndPicturesTakeASideInOneStep() {
        const Document opened = document();
        takeByKey(Qt::Key_6);
        QCOMPARE(takenInStrip(), 6);
        const JudgedSide& sixth = window().openStudy().finds()->sides->sides[5];
        QVERIFY(document() ==
                withSideTaken(opened, sixth, window().openStudy().volume()->dataBox(), window().volumeView().aspect()));
        QCOMPARE(window().document().steps().undoText(), "side: Side 6");
        QVERIFY(window().volumeView().caption().startsWith("side 6"));
        click("sides.picture2");
        QCOMPARE(takenInStrip(), 2);
        QCOMPARE(frameOf(viewpointOf(document())).forward, Vec3(0, 0, -1));
        click("sides.picture2");
        QCOMPARE(takenInStrip(), 2);  // a second click takes nothing away
        window().motionPlayer().setAngle(20);
        waitUntilIdle();
        QVERIFY2(window().volumeView().caption().startsWith("side 2, turned"),
                 qPrintable(window().volumeView().caption()));
        window().motionPlayer().setAngle(0);
        window().document().steps().undo();
        window().document().steps().undo();
        QVERIFY(document() == opened);
        QCOMPARE(takenInStrip(), static_cast<int>(window().openStudy().finds()->sides->best) + 1);
    }

    void theViewIsResetToTheSideThatIsTaken() {
        takeByKey(Qt::Key_5);
        const Document taken = document();
        lookFrom(window(), {.azimuthDegrees = 33, .elevationDegrees = 12});
        QVERIFY2(!window().volumeView().caption().contains("side"), qPrintable(window().volumeView().caption()));
        QTest::keyClick(&window(), Qt::Key_R);
        QVERIFY(document().scene.pose == taken.scene.pose);
        Document moved = document();
        moved.scene.front = {};
        window().document().edit(moved, "no front");
        click("view.cut.reset");
        QVERIFY(document().scene.front == taken.scene.front);
        QTest::keyClick(&window(), Qt::Key_R, Qt::ShiftModifier);  // all as opened, the side too
        QCOMPARE(takenInStrip(), static_cast<int>(window().openStudy().finds()->sides->best) + 1);
        QVERIFY(document().scene.exposure == window().openStudy().finds()->exposure);
    }

    void eachSideHasItsPictureWhileTheStripIsSeen() {
        QTRY_VERIFY_WITH_TIMEOUT(window().idle(), patience);
        std::vector<QImage> images;
        for (int side = 1; side <= 6; ++side) {
            images.push_back(picture(side)->icon().pixmap(QSize(104, 68)).toImage());
            QVERIFY2(isLit(images.back()), qPrintable(QString::number(side)));
        }
        const std::size_t best = window().openStudy().finds()->sides->best;
        QVERIFY(images[best] != images[0]);  // the hill lies open from there alone
        // A strip that nobody sees asks for no pictures.
        child<QAction>("view.sides")->trigger();
        QVERIFY(!child("sides")->isVisible());
        open(m_file);
        QVERIFY(!isLit(picture(1)->icon().pixmap(QSize(104, 68)).toImage()));
        child<QAction>("view.sides")->trigger();
        QTRY_VERIFY(isLit(picture(6)->icon().pixmap(QSize(104, 68)).toImage()));
        close();
        showAgain();
        QVERIFY(child("sides")->isVisible());
    }

    void aSideThatAPersonLeavesAStudyWithIsRememberedForSuchScansAndTheCaptionSaysSo() {
        takeByKey(Qt::Key_6);
        QVERIFY(window().close());
        close();
        // Also for a file that is read while the window is made.
        auto early = std::make_unique<MainWindow>(settingsFile(), [this](OpenStudy& study) { study.open(m_file); });
        QSignalSpy opened(&early->openStudy(), &OpenStudy::studyOpened);
        QVERIFY(opened.wait(patience));
        QCOMPARE(early->openStudy().finds()->source, SideSource::remembered);
        early.reset();
        showAgain();
        open(m_file);
        QCOMPARE(window().openStudy().finds()->source, SideSource::remembered);
        QCOMPARE(takenInStrip(), 6);
        QVERIFY2(window().volumeView().caption().startsWith("side 6, as last time"),
                 qPrintable(window().volumeView().caption()));
        takeByKey(Qt::Key_2);
        QVERIFY2(!window().volumeView().caption().contains("last time"), qPrintable(window().volumeView().caption()));
        // Leaving with the side that shows most forgets the choice; a side that was taken back is none.
        takeByKey(bestKey());
        open(m_file);
        QCOMPARE(window().openStudy().finds()->source, SideSource::found);
        takeByKey(Qt::Key_6);
        window().document().steps().undo();
        open(m_file);
        QCOMPARE(window().openStudy().finds()->source, SideSource::found);
    }

    void theViewIsResetToTheSideWhoseFrontCutsThoughTubeCoresWereTurned() {
        takeByKey(Qt::Key_5);
        const Document taken = document();
        QVERIFY(cuts(taken.scene.front));
        lookFrom(window(), {.azimuthDegrees = 33, .elevationDegrees = 12});
        QTest::keyClick(&window(), Qt::Key_A);
        QCOMPARE(takenInStrip(), 0);
        QTest::keyClick(&window(), Qt::Key_R);
        QVERIFY(document().scene.pose == taken.scene.pose);
    }

    void theStripLeavesFullScreenAndComparisonAlone() {
        QTest::keyClick(&window(), Qt::Key_F);
        QVERIFY(!child("sides")->isVisible());
        QTest::keyClick(&window(), Qt::Key_F5);
        QTest::keyClick(&window(), Qt::Key_F);
        QVERIFY(!child("sides")->isVisible());
        QTest::keyClick(&window(), Qt::Key_F5);
        QVERIFY(child("sides")->isVisible());
    }

    void aBeamThatAPersonSaysNamesTheSides() {
        window().document().change("beam axis", [](Document& next) {
            next.beam = {BeamAxis::minusY, BeamSource::person};
            next.scene.side = {};
            next.scene.pose.direction = {};
            next.scene.front = {};
        });
        QTRY_COMPARE(child<QAction>("room.lookInFrom1")->text(), "&1 From the probe");
        std::set<QString> tips;
        for (int side = 1; side <= 6; ++side) {
            const QString tip = picture(side)->toolTip();
            const QString name = child<QAction>(QStringLiteral("room.lookInFrom%1").arg(side))->text().mid(3);
            QVERIFY2(tip.startsWith(name + QStringLiteral(" (Ctrl+%1). ").arg(side)), qPrintable(tip));
            tips.insert(tip.section(". ", 1));
        }
        QCOMPARE(tips.size(), std::size_t{6});  // each says something else
        QCOMPARE(tips.count("As the probe looked into the body."), std::size_t{1});
        QCOMPARE(tips.count("Towards the probe, from the far end of the scan. It comes first: it shows the most."),
                 std::size_t{1});  // where the hill lies open
        QCOMPARE(takenInStrip(), 1);
        QTRY_VERIFY2(window().volumeView().caption().startsWith("from the probe"),
                     qPrintable(window().volumeView().caption()));
        const Vec3 before = frameOf(viewpointOf(document())).forward;
        QVERIFY(before == Vec3(0, -1, 0));  // no side changes by itself
        takeByKey(Qt::Key_2);
        QVERIFY(frameOf(viewpointOf(document())).forward == Vec3(0, 1, 0));
        QVERIFY(window().volumeView().caption().startsWith("from behind"));
    }

    void theTipOfTheSideThatComesFirstSaysWhy() {
        SidesFinding finding;
        const Sides sides = sidesOf({}, true, {});
        for (std::size_t i = 0; i < sides.size(); ++i) finding.sides[i].side = sides[i];
        finding.leastOpened = 0.1;
        const auto tip = [&finding](std::size_t first) {
            return tipOfSide(withFirst(finding, first), first, QStringLiteral("Ctrl+1"));
        };
        const QString probe("From the probe (Ctrl+1). As the probe looked into the body. It comes first: ");
        QCOMPARE(tip(0), probe + "no side surely shows anything behind fluid.");
        finding.sides[3].score = {.opened = 0.05, .total = 0.4};
        QCOMPARE(tip(0), probe + "what other sides show behind fluid fills too little of their pictures.");
        finding.sides[0].score = {.opened = 0.3, .total = 0.4};
        QCOMPARE(tip(0), probe + "no other side shows clearly more.");
        finding.sides[1].score = {.opened = 0.3, .total = 0.5};
        QCOMPARE(tip(1),
                 "From behind (Ctrl+1). Towards the probe, from the far end of the scan. It comes first: it shows the "
                 "most.");
        QCOMPARE(tip(0), probe + "so it did in the coarse picture, which comes before all is read.");
        QCOMPARE(tipOfSide(withFirst(finding, 1), 0, "Ctrl+1"), probe.section(" It comes", 0, 0));
    }

    void theSimulatedScanOpensFromTheProbeAndHasSidesToo() {
        window().openSimulatedScan();
        QTRY_VERIFY_WITH_TIMEOUT(window().openStudy().isSimulatedScan() && window().idle(), 30000);
        QCOMPARE(takenInStrip(), 1);
        QVERIFY(window().volumeView().caption().startsWith("from the probe"));
        takeByKey(Qt::Key_3);
        QCOMPARE(takenInStrip(), 3);
    }

private:
    [[nodiscard]] const Document& document() { return window().document().document(); }
    QToolButton* picture(int side) { return child<QToolButton>(QStringLiteral("sides.picture%1").arg(side)); }
    /// The number of the only side that the strip shows as taken; 0 if there is none.
    int takenInStrip() {
        int taken = 0;
        for (int side = 1; side <= 6; ++side)
            if (picture(side)->isChecked()) taken = taken == 0 ? side : -1;
        return taken;
    }
    void takeByKey(Qt::Key key) {
        QTest::keyClick(&window(), key, Qt::ControlModifier);
        waitUntilIdle();
    }
    Qt::Key bestKey() {
        return static_cast<Qt::Key>(Qt::Key_1 + static_cast<int>(window().openStudy().finds()->sides->best));
    }
    static bool isLit(const QImage& image) {
        for (int y = 0; y < image.height(); ++y)
            for (int x = 0; x < image.width(); ++x)
                if (qGray(image.pixel(x, y)) > 60) return true;
        return false;
    }

    QString m_file;
};

ECHOLUCENT_TEST_CLASS(TestSides)
#include "test_sides.moc"
