// What is measured in planes and on surfaces in the real main window, how exact it is, and where it stands then.
#include <QAction>
#include <QImage>
#include <QToolButton>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/app/planes/measuring_fixture.h"
#include "tests/qt_program/test_classes.h"
#include "widgets/picture_labels/measurement_drawing.h"
#include "widgets/volume_view/scene/annotation/overlay.h"

using namespace echolucent;

namespace {

const VolumeGeometry ballGrid{.size = {96, 80, 72}, .spacing = {0.5, 0.6, 0.7}};
const Vec3 ballCentre{24.1, 23.4, 24.9};
constexpr double ballRadius = 15.0;

/// A ball whose echo falls linearly outwards and is half of white at its radius.
std::shared_ptr<const Volume> ball() {
    std::vector<std::uint16_t> voxels(static_cast<std::size_t>(ballGrid.voxelCount()));
    for (std::int64_t z = 0; z < ballGrid.size[2]; ++z)
        for (std::int64_t y = 0; y < ballGrid.size[1]; ++y)
            for (std::int64_t x = 0; x < ballGrid.size[0]; ++x) {
                const Vec3 voxel(static_cast<double>(x), static_cast<double>(y), static_cast<double>(z));
                const double outside = length(ballGrid.gridMmFromVoxel(voxel) - ballCentre) - ballRadius;
                const double echo = std::clamp(0.5 - outside / 8.0, 0.01, 1.0);
                voxels[static_cast<std::size_t>(ballGrid.offset(x, y, z))] =
                    static_cast<std::uint16_t>(std::lround(echo * 60000));
            }
    return std::make_shared<const Volume>(ballGrid, Voxels(voxels), 60000.0);
}

bool isInColour(const QColor& colour) {
    return std::abs(colour.red() - measurementColour.red()) < 40 &&
           std::abs(colour.green() - measurementColour.green()) < 40 &&
           std::abs(colour.blue() - measurementColour.blue()) < 40;
}

/// Whether a line runs through a place: it is hardly wider than a pixel, so that none need have its colour whole.
bool isCrossedAt(const QImage& image, const QPointF& at) {
    for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x) {
            const QColor is = image.pixelColor(at.toPoint() + QPoint(x, y));
            if (is.red() > 130 && is.green() > 120 && is.red() - is.blue() > 60) return true;
        }
    return false;
}

/// Share of the pixels within `reach` of a place that have the measurements' colour.
double shareInColour(const QImage& image, const QPointF& at, int reach) {
    int inside = 0, all = 0;
    for (int y = -reach; y <= reach; ++y)
        for (int x = -reach; x <= reach; ++x) {
            const QPoint pixel = at.toPoint() + QPoint(x, y);
            if (x * x + y * y > reach * reach || !image.rect().contains(pixel)) continue;
            ++all;
            inside += isInColour(image.pixelColor(pixel));
        }
    return all == 0 ? 0.0 : static_cast<double>(inside) / all;
}

}  // namespace

class TestMeasuring : public QObject, private MeasuringFixture {
    Q_OBJECT

private slots:
    void initTestCase() {
        QApplication::setStyle(QStringLiteral("Fusion"));
        QLocale::setDefault(QLocale::c());
    }
    void init() { showWindow(); }
    void cleanup() { close(); }

    void distancesInTurnedPlanesAreThoseOfThePatient_data() {
        QTest::addColumn<int>("from");
        QTest::addColumn<int>("to");
        QTest::addColumn<bool>("dragged");
        QTest::newRow("0-1, clicks") << 0 << 1 << false;
        QTest::newRow("2-3, a drag") << 2 << 3 << true;
        QTest::newRow("4-5, clicks") << 4 << 5 << false;
        QTest::newRow("0-4, a drag") << 0 << 4 << true;
    }
    void distancesInTurnedPlanesAreThoseOfThePatient() {
        QFETCH(int, from);
        QFETCH(int, to);
        QFETCH(bool, dragged);
        openPoints();
        PlanePane& pane = turnedToHold({at(from), at(to)});
        key(Qt::Key_M);
        const QPointF first = pane.mapping().seenAt(at(from)), second = pane.mapping().seenAt(at(to));
        if (dragged) {
            drag(pane, first, second);
        } else {
            press(pane, first);
            press(pane, second);
        }
        QCOMPARE(measurements().size(), 1u);
        const double expected = length(patientAt(from) - patientAt(to));
        verifyClose("distance", value(0), expected);
        QCOMPARE(measurements()[0].ground, MeasurementGround::plane);
        QCOMPARE(window().document().steps().undoText(), "distance 1");
        verifySeenBright(pane, {from, to});
    }

    void anglesInTurnedPlanesAreThoseOfThePatient_data() {
        QTest::addColumn<QList<int>>("points");
        QTest::newRow("0-5-3") << QList<int>{0, 5, 3};
        QTest::newRow("1-2-4") << QList<int>{1, 2, 4};
        QTest::newRow("3-0-1") << QList<int>{3, 0, 1};
    }
    void anglesInTurnedPlanesAreThoseOfThePatient() {
        QFETCH(QList<int>, points);
        openPoints();
        PlanePane& pane = turnedToHold({at(points[0]), at(points[1]), at(points[2])});
        QTest::keyClick(&window(), Qt::Key_M, Qt::ShiftModifier);
        for (const int point : points) press(pane, pane.mapping().seenAt(at(point)));
        QCOMPARE(measurements().size(), 1u);
        QCOMPARE(measurements()[0].kind, MeasurementKind::angle);
        const Vec3 one = patientAt(points[0]) - patientAt(points[1]),
                   other = patientAt(points[2]) - patientAt(points[1]);
        const double expected = std::acos(one.dot(other) / (length(one) * length(other))) * 180.0 / std::numbers::pi;
        verifyClose("angle", value(0), expected);
        QCOMPARE(window().document().steps().undoText(), "angle 1");
        verifySeenBright(pane, points);
    }

    /// A click goes to whole pixels, as mice do: a distance is as exact as two pixels then.
    void aClickIsAsExactAsAPixel() {
        openPoints();
        PlanePane& pane = turnedToHold({at(0), at(1)});
        key(Qt::Key_M);
        for (const int point : {0, 1})
            QTest::mouseClick(&pane, Qt::LeftButton, {}, pane.mapping().seenAt(at(point)).toPoint());
        QCOMPARE(measurements().size(), 1u);
        const double apart = std::abs(value(0) - length(patientAt(0) - patientAt(1)));
        qInfo("whole pixels: %.3f mm off, a pixel is %.3f mm", apart, pane.mapping().mmPerPixel());
        QVERIFY(apart <= std::sqrt(2.0) * pane.mapping().mmPerPixel());
    }

    void twoPlacesOfASurfaceIn3d() {
        open(file("ball.mha", {ball()}));
        Document next = document();
        next.curves.manual = {{{0.5, 0.0}, {0.5, 1.0}, {1.0, 1.0}}};
        next.panes.at(firstPane).curve = CurveKind::manual;
        next.scene.pose.direction = {.azimuth = 23.0, .elevation = -14.0};
        window().document().edit(next, "ball");
        waitUntilIdle();
        key(Qt::Key_M);
        const Camera camera = window().volumeView().shownCamera();
        const QSize size = window().volumeView().size();
        const QPoint centre(size.width() / 2, size.height() / 2);
        const std::vector<QPointF> clicks{{centre.x() - 70.5, centre.y() + 40.5},
                                          {centre.x() + 90.5, centre.y() - 33.5}};
        std::vector<Vec3> expected;
        for (const QPointF& pixel : clicks) {
            clickIn3d(pixel);
            // Where the ray of the pixel first meets the ball.
            const PicturePlace place{(pixel.x() - size.width() / 2.0) / size.height(),
                                     (pixel.y() - size.height() / 2.0) / size.height()};
            const Vec3 onRay = gridPlaceAt(camera, place, camera.frame.forward.dot(ballCentre));
            const double aside = length(onRay - ballCentre);
            QVERIFY(aside < ballRadius);
            expected.push_back(onRay - camera.frame.forward * std::sqrt(ballRadius * ballRadius - aside * aside));
        }
        QCOMPARE(measurements().size(), 1u);
        QCOMPARE(measurements()[0].ground, MeasurementGround::surface);
        // A ray is sampled every tenth of a unit, so that each place lies up to that behind the surface; interpolation
        // between voxels moves the surface itself by as little.
        const double tolerance = 0.2 * ballGrid.unit();
        for (int i = 0; i < 2; ++i) {
            const double off =
                length(measurements()[0].placesMm[static_cast<std::size_t>(i)] - expected[static_cast<std::size_t>(i)]);
            qInfo("place %d lies %.4f mm beside the ball's surface", i, off);
            QVERIFY(off <= tolerance);
        }
        const double wanted = length(expected[1] - expected[0]);
        qInfo("distance %.4f mm, expected %.4f mm, off by %.2g", value(0), wanted, value(0) / wanted - 1.0);
        QVERIFY(std::abs(value(0) - wanted) <= 2.0 * tolerance);
        // Where nothing shows, and for an angle, nothing is marked, and the window says why.
        clickIn3d({6.5, 6.5});
        QVERIFY2(message().contains("Nothing shows where you clicked"), qPrintable(message()));
        QTest::keyClick(&window(), Qt::Key_M, Qt::ShiftModifier);
        QVERIFY(!message().contains("Nothing shows"));
        clickIn3d(clicks[0]);
        QVERIFY2(message().contains("Angles are measured in planes"), qPrintable(message()));
        QCOMPARE(measurements().size(), 1u);
        key(Qt::Key_M);
        Document mean = document();
        mean.scene.look.mode = RenderMode::mean;
        window().document().edit(mean, "mean");
        clickIn3d(clicks[0]);
        QVERIFY2(message().contains("Means show no surface"), qPrintable(message()));
        window().document().steps().undo();
        // A drag still turns the picture.
        const Pose pose = document().scene.pose;
        dragIn3d(clicks[0].toPoint(), clicks[1].toPoint());
        QVERIFY(!(document().scene.pose == pose));
        QCOMPARE(measurements().size(), 1u);
        waitUntilIdle();
    }

    void aDoubleClickOnASurfaceMarksOnePlace() {
        open(file("ball.mha", {ball()}));
        Document next = document();
        next.curves.manual = {{{0.5, 0.0}, {0.5, 1.0}, {1.0, 1.0}}};
        next.panes.at(firstPane).curve = CurveKind::manual;
        window().document().edit(next, "ball");
        waitUntilIdle();
        key(Qt::Key_M);
        const QPoint middle = QRect({}, window().volumeView().size()).center();
        QTest::mouseDClick(pictureWindow(), Qt::LeftButton, {}, middle);
        QCOMPARE(measurements().size(), 0u);
        QTRY_COMPARE(window().volumeView().overlay().discs.size(), 1u);  // the place that is marked
        QTest::mouseClick(pictureWindow(), Qt::LeftButton, {}, middle + QPoint(40, 20));
        QCOMPARE(measurements().size(), 1u);
        QVERIFY(value(0) > 1.0);
        waitUntilIdle();
    }

    void withoutASpacingTheToolIsRefused() {
        VolumeGeometry unknown = obliqueGrid();
        unknown.spacingKnown = false;
        open(file("unknown.mha", {markedPoints(unknown)}));
        key(Qt::Key_F3);
        QTRY_VERIFY(window().idle());
        for (const Qt::KeyboardModifiers modifiers :
             {Qt::KeyboardModifiers{}, Qt::KeyboardModifiers(Qt::ShiftModifier)}) {
            QTest::keyClick(&window(), Qt::Key_M, modifiers);
            QVERIFY2(message().contains("the spacing of this volume is not known, so that nothing can be measured"),
                     qPrintable(message()));
            QVERIFY(!child<QToolButton>("measurements.distance")->isChecked());
            QVERIFY(!child<QToolButton>("measurements.angle")->isChecked());
            QVERIFY(!child<QAction>("room.measureDistance")->isChecked());
        }
        PlanePane& a = pane("planes.a");
        press(a, QPointF(a.width() / 2.0 - 30, a.height() / 2.0));
        press(a, QPointF(a.width() / 2.0 + 30, a.height() / 2.0));
        QVERIFY(measurements().empty());
        raise("dock.room");
        click("measurements.distance");
        QVERIFY(!child<QToolButton>("measurements.distance")->isChecked());
    }

    void aValueStandsAlikeInListPlanePictureAndFile() {
        openPoints();
        PlanePane& pane = turnedToHold({at(0), at(1)});
        key(Qt::Key_M);
        for (const int point : {0, 1}) press(pane, pane.mapping().seenAt(at(point)));
        key(Qt::Key_M);
        QTest::mouseMove(&window().volumeView());
        const std::string text = measurementText(measurements()[0], geometry()).value();
        const double expected = length(patientAt(0) - patientAt(1));
        QCOMPARE(QString::fromStdString(text), QString::number(expected, 'f', 1) + " mm");
        // The list.
        QCOMPARE(list().item(0)->text(), QString::fromStdString("1. " + text + ", in a plane"));
        // The plane that holds it, and no other.
        for (const char* name : {"planes.a", "planes.b", "planes.c"}) {
            PlanePane& each = this->pane(name);
            QCOMPARE(each.scene()->measurements.size(), 1u);
            QCOMPARE(each.scene()->measurements[0].text, text);
            const QImage shown = each.grab().toImage();
            const bool holds = &each == &pane;
            for (const int point : {0, 1}) {
                const QPointF seen = each.mapping().seenAt(at(point)) * each.devicePixelRatioF();
                QVERIFY((shareInColour(shown, seen, 2) > 0.8) == holds);
            }
        }
        // The 3D view.
        waitUntilIdle();
        const Overlay overlay = window().volumeView().overlay();
        QCOMPARE(overlay.texts.size(), 1u);
        const std::string in3d = text + " (in plane " + std::string(nameOf(pane.plane())) + ")";
        QCOMPARE(overlay.texts[0].text, in3d);
        verifyDrawnIn(window().volumeView().screenImage(), in3d);
        // The file.
        const QString path = temporaryFolder().filePath("measured.png");
        QVERIFY(window().savePicture(path));
        verifyDrawnIn(QImage(path), in3d);
        // Once no plane holds it, the words do not name one.
        Document turned = document();
        turned.scene.planes.offsetMm += Vec3(3, 5, 7);
        window().document().edit(turned, "step planes");
        QCOMPARE(window().volumeView().overlay().texts.at(0).text, text + " (in a plane)");
        // Without the measurement nothing of its colour is there.
        click("measurements.removeAll");
        QVERIFY(window().savePicture(path));
        const QImage without(path);
        for (const int point : {0, 1}) QCOMPARE(shareInColour(without, seenAt(without, at(point)), 2), 0.0);
        QVERIFY(!isCrossedAt(without, (seenAt(without, at(0)) + seenAt(without, at(1))) / 2.0));
    }

private:
    /// In the patient, which the program's grid mm play no part in.
    static Vec3 patientAt(int point) {
        return obliqueGrid().patientFromVoxel(markedVoxels[static_cast<std::size_t>(point)]);
    }
    void verifyClose(const char* what, double is, double expected) {
        const double error = std::abs(is / expected - 1.0);
        qInfo("%s %.6f, expected %.6f: relative error %.2g", what, is, expected, error);
        QVERIFY(error <= 1e-4);
    }
    /// The plane shows the marked voxels where they were clicked, in the middle of what is bright there.
    void verifySeenBright(PlanePane& pane, const QList<int>& points) {
        QTRY_VERIFY(window().idle());
        for (const int point : points) {
            const QPointF seen = pane.mapping().seenAt(at(point));
            double sum = 0.0;
            QPointF middle;
            constexpr int reach = 14;
            for (int y = -reach; y <= reach; ++y)
                for (int x = -reach; x <= reach; ++x) {
                    const QPoint pixel = seen.toPoint() + QPoint(x, y);
                    const double bright = qGray(pane.image().pixel(pixel)) > 140 ? 1.0 : 0.0;
                    sum += bright;
                    middle += (QPointF(pixel) + QPointF(0.5, 0.5)) * bright;
                }
            QVERIFY(sum > 10);
            const QPointF off = middle / sum - seen;
            QVERIFY2(std::hypot(off.x(), off.y()) < 1.0, qPrintable(QString("%1, %2").arg(off.x()).arg(off.y())));
        }
    }
    QPointF seenAt(const QImage& picture, const Vec3& gridMm) {
        const PicturePlace place = *placeInPicture(window().volumeView().shownCamera(), gridMm);
        return {picture.width() / 2.0 + place[0] * picture.height(),
                picture.height() / 2.0 + place[1] * picture.height()};
    }
    /// Marks at points 0 and 1, a dashed line between them, and words beside one of them.
    void verifyDrawnIn(const QImage& picture, const std::string& text) {
        QVERIFY(!picture.isNull());
        const double ratio = window().volumeView().devicePixelRatioF();
        const QPointF from = seenAt(picture, at(0)), to = seenAt(picture, at(1));
        const int reach = qRound(2 * ratio);
        QVERIFY(shareInColour(picture, from, reach) > 0.8);
        QVERIFY(shareInColour(picture, to, reach) > 0.8);
        // Half of the line and more is dashes, and there are gaps.
        int crossed = 0;
        constexpr int places = 100;
        for (int i = 0; i < places; ++i) crossed += isCrossedAt(picture, from + (to - from) * (0.15 + 0.007 * i));
        QVERIFY2(crossed > places / 2 && crossed < places - 5, qPrintable(QString::number(crossed)));
        const QPointF right = from.x() > to.x() ? from : to, left = from.x() > to.x() ? to : from;
        const QSizeF words = QSizeF(7.0 * static_cast<double>(text.size()), 14.0) * ratio;
        const QPointF aside(measurementTextGap * ratio + words.width() / 2.0, 0.0);
        const auto lettersAbout = [&](const QPointF& middle) {
            int inside = 0;
            for (int y = 0; y < words.height(); ++y)
                for (int x = 0; x < words.width(); ++x) {
                    const QPoint pixel =
                        (middle + QPointF(x - words.width() / 2.0, y - words.height() / 2.0)).toPoint();
                    inside += picture.rect().contains(pixel) && isInColour(picture.pixelColor(pixel));
                }
            return inside;
        };
        // The words stand right of the line, else left of it. If neither has room, they stand at the picture's edge.
        const QPointF atEdge(picture.width() - words.width() / 2.0, right.y()), line(0.0, words.height() + 2.0);
        const int inside = std::max({lettersAbout(right + aside), lettersAbout(left - aside),
                                     lettersAbout(atEdge + line), lettersAbout(atEdge - line)});
        QVERIFY2(inside > 40, qPrintable(QString::number(inside)));
    }
};

ECHOLUCENT_TEST_CLASS(TestMeasuring)

#include "test_measuring.moc"
