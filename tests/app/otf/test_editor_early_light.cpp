// The light that is held back early, in the curve editor of the real window.
#include <QDockWidget>
#include <numeric>

#include "app/compare/compare_room.h"
#include "app/otf/pane_otfs.h"
#include "processing/pane_picture/pane_measures.h"
#include "tests/app/window_fixture.h"
#include "tests/processing/tube_core/plane_volume.h"
#include "tests/qt_program/test_classes.h"
#include "widgets/compare/compare_panel.h"
#include "widgets/otf_editor/curve_canvas.h"

using namespace echolucent;

class TestEditorEarlyLight : public QObject, private WindowFixture {
    Q_OBJECT

private slots:
    void initTestCase() {
        PlaneVolume plane;
        plane.size = {60, 60, 70};
        plane.distanceMm = 40;
        m_file = file("plane.mha", {std::make_shared<const Volume>(plane.make())});
        teach();
        lookAtNoPicture();
        lookAlongAssumedBeam();
        show();
        useLook(Look{});
        open(m_file);
        m_begun = window().document().document();
    }
    /// One window, in which every function begins anew.
    void init() {
        window().document().begin(m_begun);
        window().otfEditor().setShowsEarlyLight(false);
        child<QDockWidget>("dock.otfEditor")->raise();
        waitUntilIdle();
    }
    void cleanupTestCase() { close(); }

    void hazeIsSeenAtItsIntensityAndAStepAtTheWallHoldsNothingBack() {
        render(hazed(0.1));
        waitUntilIdle();
        QVERIFY(!light());  // it is off at first
        click("otfEditor.earlyLight");
        QTRY_VERIFY_WITH_TIMEOUT(light(), 30000);
        expectLightOfThePicture();
        QVERIFY(light()->early > 100 && light()->sum() > 0.5);
        // Fluid has a tenth of the tissue's echo.
        QVERIFY(std::accumulate(light()->held.begin(), light()->held.begin() + 16, 0.0) > 0.99 * light()->sum());
        QVERIFY(window().otfEditor().canvas().accessibleDescription().contains("Held back early"));
        const int found = window().surfaces().timesFound();
        render(hazed(0.0));
        QVERIFY(!light());  // of another curve
        QTRY_VERIFY_WITH_TIMEOUT(light(), 30000);
        expectLightOfThePicture();
        QVERIFY(light()->rays > 100);
        QCOMPARE(light()->early, 0);
        QCOMPARE(light()->sum(), 0.0);
        QVERIFY2(window().surfaces().timesFound() == found, "an edit of the curve finds no surfaces anew");
    }

    void theComparisonMeasuresWithTheSameSurfaces() {
        window().document().change("panes", [](Document& next) {
            next.panes = {{.curve = CurveKind::manual}, {.curve = CurveKind::linear}};
        });
        window().compareRoom().setShown(true);
        child<QDockWidget>("dock.otfEditor")->raise();  // the panel Compare came to the front
        click("otfEditor.earlyLight");
        const auto measured = [this] {
            const auto& rows = child<ComparePanel>("compare")->rows();
            return light() && window().idle() && rows.size() == 2 && rows[0].depth && rows[1].depth;
        };
        QTRY_VERIFY_WITH_TIMEOUT(measured(), 30000);
        const int found = window().surfaces().timesFound();
        render(hazed(0.1));
        QTRY_VERIFY_WITH_TIMEOUT(measured(), 30000);
        QCOMPARE(child<ComparePanel>("compare")->rows()[0].depth->early, light()->early);
        QVERIFY(light()->early > 100);
        QCOMPARE(window().surfaces().timesFound(), found);
        lookFrom(window(), Viewpoint{.azimuthDegrees = 30});
        QTRY_VERIFY_WITH_TIMEOUT(measured(), 30000);
        QVERIFY2(window().surfaces().timesFound() == found + 1, "both measure the new view with surfaces found once");
    }

    void itFollowsTheViewAndADragShowsNone() {
        render(hazed(0.1));
        click("otfEditor.earlyLight");
        QTRY_VERIFY_WITH_TIMEOUT(light(), 30000);
        const EarlyLight before = *light();
        lookFrom(window(), Viewpoint{.azimuthDegrees = 30});
        QTRY_VERIFY_WITH_TIMEOUT(light() && *light() != before, 30000);
        expectLightOfThePicture();
        // A drag of a node.
        CurveCanvas& canvas = window().otfEditor().canvas();
        const QPoint node = canvas.axes().positionOf(hazed(0.1).nodes[0]).toPoint();
        QTest::mousePress(&canvas, Qt::LeftButton, {}, node);
        QTest::mouseMove(&canvas, node - QPoint(0, 12));
        QVERIFY(window().document().previewing());
        QVERIFY(!light());
        QTest::mouseRelease(&canvas, Qt::LeftButton, {}, node - QPoint(0, 12));
        QTRY_VERIFY_WITH_TIMEOUT(light(), 30000);
        expectLightOfThePicture();
    }

    void nothingIsMeasuredWhileNobodyLooks() {
        render(hazed(0.1));
        click("otfEditor.earlyLight");
        QTRY_VERIFY_WITH_TIMEOUT(light(), 30000);
        const EarlyLight before = *light();
        child<QDockWidget>("dock.method")->raise();
        QTRY_VERIFY(!light());
        child<QDockWidget>("dock.otfEditor")->raise();
        QTRY_VERIFY(light() && *light() == before);
        click("otfEditor.earlyLight");
        QVERIFY(!light());
        click("otfEditor.earlyLight");
        QVERIFY(light() && *light() == before);  // it was kept
    }

private:
    [[nodiscard]] const std::optional<EarlyLight>& light() { return window().otfEditor().canvas().earlyLight(); }
    /// Some opacity up to an intensity of 0.25, opaque from there on.
    static ManualCurve hazed(double opacity) { return {{{0.25, opacity}, {0.25, 1.0}}}; }
    void render(const ManualCurve& curve) {
        window().otfEditor().openManualCurve(curve);
        QCOMPARE(window().document().document().panes.at(firstPane).curve, CurveKind::manual);
    }
    void expectLightOfThePicture() {
        const Document& document = window().document().document();
        const Volume& volume = *window().openStudy().volume();
        const MeasuredSurfaces surfaces = *measuredSurfacesOf(surfaceSourceOf(document), volume);
        const EarlyLight expected =
            *earlyLightOf(volume, viewpointOf(document), surfaces.rays, classificationOf(document, firstPane, {}));
        QVERIFY(*light() == expected);
    }

    QString m_file;
    Document m_begun;
};

ECHOLUCENT_TEST_CLASS(TestEditorEarlyLight)

#include "test_editor_early_light.moc"
