// The compared panes coloured by their shown depths: each measured ray at its place, in no drag and in no motion.
#include <QCheckBox>
#include <cmath>

#include "app/motion/motion_player.h"
#include "io/document/session_file.h"
#include "processing/pane_picture/pane_measures.h"
#include "processing/picture/picture_place.h"
#include "tests/app/compare/compare_fixture.h"
#include "tests/qt_program/test_classes.h"
#include "widgets/surface_colours.h"

using namespace echolucent;

namespace {

/// What a colour says, by its hue; no value for a grey.
std::optional<ShownSurface> meaningOf(const QColor& colour) {
    constexpr int oneHue = 6, coloured = 80;  // degrees, and of 255
    if (colour.hsvSaturation() < coloured) return std::nullopt;
    for (const ShownSurface shown : {ShownSurface::right, ShownSurface::early, ShownSurface::late})
        if (std::abs(colour.hsvHue() - surfaceColour(shown).hsvHue()) <= oneHue) return shown;
    return std::nullopt;
}

QPointF pixelOf(const Camera& camera, const QImage& image, const Vec3& gridMm) {
    const auto place = *placeInPicture(camera, gridMm);
    return {0.5 * image.width() + place[0] * image.height(), 0.5 * image.height() + place[1] * image.height()};
}

double length(const QPointF& vector) { return std::hypot(vector.x(), vector.y()); }

bool isGrey(const QColor& colour) { return colour.red() == colour.green() && colour.green() == colour.blue(); }

}  // namespace

class TestCompareColours : public QObject, private CompareFixture {
    Q_OBJECT

private slots:
    void initTestCase() {
        m_file = file("still.mha", {smallPhantom(PhantomScene::shapes, 5)});
        lookAtNoPicture();
        begin({{.curve = CurveKind::adaptive}, {.curve = CurveKind::parabolic}});
        m_begun = document();
    }
    /// One window, in which every function begins anew.
    void init() {
        window().document().begin(m_begun);
        QTRY_VERIFY_WITH_TIMEOUT(window().idle() && views().settled() && panel().rows().size() == panes &&
                                     panel().rows()[1].depth && !views().coloured(),
                                 30000);
    }
    void cleanupTestCase() { close(); }

    void eachRayHasTheColourOfWhatItsPaneShows() {
        const std::vector<QImage> plain = images();
        QVERIFY(!views().coloured());
        click("compare.colours");
        QTRY_VERIFY(views().coloured());
        expectColoursOfRays();
        for (std::size_t i = 0; i < panes; ++i) {
            // Between the data and the edge no ray is measured: there the picture is grey.
            QVERIFY(isGrey(images()[i].pixelColor(1, 1)));
            QCOMPARE(qRed(images()[i].pixel(1, 1)), qGray(plain[i].pixel(1, 1)));
            QVERIFY(grid().pane(i).image() == images()[i]);
        }
        // In perspective, from another side.
        Document next = document();
        next.scene.look.projection = Projection::perspective;
        next.scene.pose.direction.azimuth = 25;
        next.scene.pose.direction.roll = 15;
        window().document().edit(next, "perspective");
        QTRY_VERIFY_WITH_TIMEOUT(window().idle() && views().settled() && views().coloured(), 30000);
        expectColoursOfRays();
    }

    void theLegendHasTheNumbersOfTheTable() {
        const QString numbers = grid().pane(0).face().numbers;
        click("compare.colours");
        QTRY_VERIFY(views().coloured());
        for (std::size_t i = 0; i < panes; ++i) {
            const PaneFace& face = grid().pane(i).face();
            QCOMPARE(face.legend.size(), std::size_t{4});
            for (const SurfaceLegendEntry& entry : face.legend)
                QCOMPARE(*entry.percent, std::lround(100.0 * *panel().rows()[i].depth->share(entry.shown)));
            // The line that the legend takes the place of is said all the same.
            QCOMPARE(grid().pane(i).accessibleDescription(), numbersOf(panel().rows()[i]));
        }
        click("compare.colours");
        QVERIFY(grid().pane(0).face().legend.empty());
        QCOMPARE(grid().pane(0).face().numbers, numbers);
    }

    void theSwitchIsOneStepThatSessionsKeep() {
        const std::vector<QImage> plain = images();
        const int steps = window().document().steps().index();
        click("compare.colours");
        QVERIFY(document().comparison.colours);
        QCOMPARE(window().document().steps().index(), steps + 1);
        QTRY_VERIFY(views().coloured());
        const std::vector<QImage> coloured = images();
        QVERIFY(coloured != plain);
        const auto read = sessionFromJson(jsonOf(SavedSession{.document = document()}), "session");
        QVERIFY(read.has_value() && read->document == document());
        window().document().steps().undo();
        QVERIFY(!document().comparison.colours && !child<QCheckBox>("compare.colours")->isChecked());
        QVERIFY(!grid().pane(0).face().coloured);
        QVERIFY(!views().coloured());
        QVERIFY(images() == plain);
        window().document().steps().redo();
        QVERIFY(child<QCheckBox>("compare.colours")->isChecked());
        QTRY_VERIFY(images() == coloured);
    }

    void aHandAndAMotionShowPlainPictures() {
        click("compare.colours");
        QTRY_VERIFY(views().coloured());
        const auto rays = panel().rows()[0].depth->rays();
        ComparePane& pane = grid().pane(1);
        const QPoint from = pane.pictureRect().center();
        QTest::mousePress(&pane, Qt::LeftButton, {}, from);
        sendMove(pane, from + QPoint(60, 10), Qt::LeftButton);
        expectPlain();
        QVERIFY2(pane.face().coloured, "frames do not change with every drag");
        QTRY_VERIFY_WITH_TIMEOUT(window().idle() && views().settled(), 30000);  // the hand rests, and holds
        expectPlain();
        QTest::mouseRelease(&pane, Qt::LeftButton, {}, from + QPoint(60, 10));
        QTRY_VERIFY_WITH_TIMEOUT(views().coloured() && views().settled(), 30000);
        QVERIFY(panel().rows()[0].depth->rays() != rays);  // of the new view
        expectColoursOfRays();
        // A drag that changes no ray: the middle button moves the picture.
        drag(pane, from, QPoint(25, 0), Qt::MiddleButton);
        QTRY_VERIFY_WITH_TIMEOUT(window().idle() && views().coloured() && views().settled(), 30000);
        expectColoursOfRays();
        window().motionPlayer().togglePlaying();
        QTRY_VERIFY(!views().coloured());
        expectPlain();
        window().motionPlayer().togglePlaying();
        QTRY_VERIFY_WITH_TIMEOUT(window().idle() && views().coloured() && views().settled(), 30000);
        expectColoursOfRays();
    }

    void aWipeIsColouredAndADifferenceIsNot() {
        choose(child<QComboBox>("compare.layout"), static_cast<int>(ComparisonLayout::difference));
        waitForFrame();
        const QImage difference = grid().pair().image();
        const QString numbers = grid().pair().face().numbers;
        choose(child<QComboBox>("compare.layout"), static_cast<int>(ComparisonLayout::wipe));
        waitForFrame();
        click("compare.colours");
        QTRY_VERIFY(views().coloured());
        const QImage wiped = grid().pair().image();
        choose(child<QComboBox>("compare.layout"), static_cast<int>(ComparisonLayout::difference));
        waitForFrame();
        QVERIFY(!views().coloured());
        QVERIFY2(grid().pair().image() == difference, "a difference is that of plain pictures");
        QCOMPARE(grid().pair().face().numbers, numbers);
        QVERIFY(!child<QCheckBox>("compare.colours")->isEnabled());
        QVERIFY(grid().pair().face().legend.empty());
        choose(child<QComboBox>("compare.layout"), static_cast<int>(ComparisonLayout::wipe));
        waitForFrame();
        QVERIFY(views().coloured());
        QVERIFY(child<QCheckBox>("compare.colours")->isEnabled());
        QVERIFY(grid().pair().image() == images()[0]);
        QVERIFY2(grid().pair().image() == wiped, "and a wipe is coloured again");
        QCOMPARE(grid().pair().face().legend, surfaceLegend({}));
        QVERIFY2(grid().pair().face().name.startsWith("on the left: 1 ") &&
                     grid().pair().face().name.contains(", on the right: 2 "),
                 qPrintable(grid().pair().face().name));
    }

    void thePageHasColoursAndLegend() {
        const QString path = temporaryFolder().filePath("colours.html");
        const QImage plain = views().imageToSave(0);
        QCOMPARE(plain.size(), images()[0].size());
        click("compare.colours");
        QTRY_VERIFY(views().coloured());
        const QImage saved = views().imageToSave(0);
        QCOMPARE(saved.copy(images()[0].rect()), images()[0].convertToFormat(saved.format()));
        int right = 0;
        for (int x = 0; x < saved.width(); ++x)
            right += meaningOf(saved.pixelColor(x, (images()[0].height() + saved.height()) / 2)) == ShownSurface::right;
        QVERIFY(right > 5);  // its sample in the legend below
        window().compareRoom().savePage(path);
        waitUntilRest();
        QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(path), 30000);
        QFile file(path);
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArray page = file.readAll();
        QVERIFY(page.contains("Right, blue-green"));
        QVERIFY(page.contains("also if the motion keeps one"));
    }

private:
    static constexpr std::size_t panes = 2;
    Document m_begun;

    [[nodiscard]] const ComparedViews& views() { return window().compareRoom().views(); }
    void expectPlain() {
        QVERIFY(!views().coloured());
        for (std::size_t i = 0; i < panes; ++i) {
            QVERIFY(grid().pane(i).face().legend.empty());
            QVERIFY(grid().pane(i).image() == images()[i]);
            for (int x = 0; x < images()[i].width(); x += 3)
                QVERIFY(!meaningOf(images()[i].pixelColor(x, images()[i].height() / 2)) ||
                        *meaningOf(images()[i].pixelColor(x, images()[i].height() / 2)) == ShownSurface::early);
        }
    }
    /// The rays and what is shown of them are those that the command line measures.
    void expectColoursOfRays() {
        const auto raw = window().openStudy().study()->phases[0];
        const MeasuredSurfaces surfaces = *measuredSurfacesOf(surfaceSourceOf(document()), *raw);
        const auto measured = *measuresOfPanes(document(), {.scans = {raw}});
        const Camera camera = views().frame()->request.settings.camera;
        const ViewFrame frame = frameOf(viewpointOf(document()));
        const double apartMm = surfaces.apartUnits[0] * raw->geometry().unit();
        std::vector<Vec3> surfacesMm;
        for (const SurfaceRay& ray : surfaces.rays)
            surfacesMm.push_back(ray.pointMm + frame.forward * (ray.surfaceDepthMm - frame.forward.dot(ray.pointMm)));
        for (std::size_t i = 0; i < panes; ++i) {
            const QImage& image = images()[i];
            const std::vector<ShownSurface>& shown = measured[i]->measures.shown;
            QCOMPARE(shown.size(), surfaces.rays.size());
            std::vector<QPointF> places;
            for (const Vec3& surface : surfacesMm) places.push_back(pixelOf(camera, image, surface));
            // In perspective a nearer surface may hide another one.
            const auto isHidden = [&](std::size_t ray) {
                const double side =
                    length(pixelOf(camera, image, surfacesMm[ray] + frame.right * apartMm) - places[ray]);
                for (std::size_t other = 0; other < places.size(); ++other) {
                    const QPointF apart = places[other] - places[ray];
                    if (surfaces.rays[other].surfaceDepthMm < surfaces.rays[ray].surfaceDepthMm &&
                        length(apart) < 0.8 * side)
                        return true;
                }
                return false;
            };
            ShownDepth seen;
            for (std::size_t ray = 0; ray < shown.size(); ++ray) {
                if (camera.projection == Projection::perspective && isHidden(ray)) continue;
                const QPoint pixel(static_cast<int>(std::floor(places[ray].x())),
                                   static_cast<int>(std::floor(places[ray].y())));
                QVERIFY(image.rect().contains(pixel));
                QVERIFY(meaningOf(image.pixelColor(pixel)).value_or(ShownSurface::never) == shown[ray]);
                seen.count(shown[ray]);
            }
            QVERIFY(seen.rays() > 20);
            if (camera.projection == Projection::parallel) QVERIFY(seen == *panel().rows()[i].depth);
        }
    }
};

ECHOLUCENT_TEST_CLASS(TestCompareColours)

#include "test_compare_colours.moc"
