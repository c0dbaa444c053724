// Left, right, up and down of the 3D view and of the render box, against a volume whose corners are told apart, in the
// real main window.
#include <QImage>
#include <array>
#include <cmath>

#include "app/planes/edge_letters.h"
#include "processing/viewpoint/box_section.h"
#include "tests/app/planes/marked_corners.h"
#include "tests/app/planes/room_fixture.h"
#include "tests/qt_program/test_classes.h"

using namespace echolucent;

class TestMarkedCorners : public QObject, private RoomFixture {
    Q_OBJECT

private slots:
    void initTestCase() {
        QApplication::setStyle(QStringLiteral("Fusion"));
        m_file = file("corners.mha", {markedCorners()});
    }
    void init() {
        show();
        window().resize(1280, 720);
        useLook(Look{});
        open(m_file);
        key(Qt::Key_F3);
        QTRY_VERIFY(window().idle());
        // Opaque from 40 of 255 on, unlit and without interpolation: a pixel shows the block that lies in front.
        Document next = document();
        next.scene.look.interpolation = Interpolation::nearest;
        next.scene.look.colourMap = ColourMap::grey;
        next.curves.manual = {{{40.0 / 255, 0.0}, {40.0 / 255, 1.0}, {1.0, 1.0}}};
        next.panes.at(firstPane).curve = CurveKind::manual;
        window().document().edit(next, "blocks");
        waitUntilIdle();
    }
    void cleanup() { close(); }

    void theViewOfTheProbeIsThatOfPlaneC() {
        takeSide(1);
        const ViewFrame probe = frameOf(Viewpoint{.beamAxis = document().beam.axis});
        const QImage picture = window().volumeView().convergedImage();
        for (int corner = 0; corner < 8; ++corner) {
            const Vec3 fromCentre = at(corner) - dataBox().centreMm();
            if (probe.forward.dot(fromCentre) > 0) continue;  // it lies behind another block
            const QPoint pixel = seenIn3d(at(corner));
            QCOMPARE(pixel.x() > window().volumeView().width() / 2, probe.right.dot(fromCentre) > 0);
            QCOMPARE(pixel.y() > window().volumeView().height() / 2, probe.down.dot(fromCentre) > 0);
            QCOMPARE(valueAt(picture, pixel), cornerValue(corner));
        }
    }

    void eachSideShowsItsOwnCornersUnmirrored() {
        key(Qt::Key_B);
        for (int number = 1; number <= 6; ++number) {
            verifyTheSidesCorners(number);
            if (QTest::currentTestFailed()) return;
        }
    }

    void theFaceAtTheLeftOfThePictureCutsWhatIsSeenThere_data() {
        QTest::addColumn<int>("number");
        for (const int number : {1, 3, 6}) QTest::addRow("Ctrl+%d", number) << number;
    }
    void theFaceAtTheLeftOfThePictureCutsWhatIsSeenThere() {
        QFETCH(int, number);
        key(Qt::Key_B);
        takeSide(number);
        QPoint left(1 << 20, 0), right(0, 0);
        for (int axis = 0; axis < 3; ++axis)
            for (const int sign : {-1, 1}) {
                const QPoint middle = seenIn3d(middleOf(placed(), {axis, sign}));
                if (middle.x() < left.x()) left = middle;
                if (middle.x() > right.x()) right = middle;
            }
        const QPoint third = (right - left) / 3;
        dragIn3d(left, left + third);
        waitUntilIdle();
        QCOMPARE(window().document().steps().undoText(), "size of the box");
        const QImage picture = window().volumeView().convergedImage();
        int cut = 0, kept = 0;
        for (int corner = 0; corner < 8; ++corner) {
            const QPoint pixel = seenIn3d(at(corner));
            const bool inside = pixel.x() > left.x() + third.x();
            (inside ? kept : cut) += 1;
            QCOMPARE(valueAt(picture, pixel) > 0, inside);
        }
        QCOMPARE(cut, 4);
        QCOMPARE(kept, 4);
    }

    void thePatientsLettersStandAtTheEdgesThatPointThere() {
        VolumeGeometry geometry;  // x runs to the patient's back, y to the head, z to the right
        geometry.direction = {0, 0, -1, 1, 0, 0, 0, 1, 0};
        const ViewFrame alongBeam = frameOf(Viewpoint{});
        QVERIFY(alongBeam.right == Vec3(1, 0, 0));
        QVERIFY(alongBeam.down == Vec3(0, 1, 0));
        QVERIFY(edgeLetters(alongBeam, BeamAxis::plusZ, geometry).words == (std::array<QString, 4>{}));
        geometry.patientFrameKnown = true;
        QVERIFY(edgeLetters(alongBeam, BeamAxis::plusZ, geometry).words ==
                (std::array<QString, 4>{"A", "P", "F", "H"}));
        // The beam runs down in this picture, so that the probe stands above it.
        const ViewFrame fromHead{{1, 0, 0}, {0, 0, 1}, {0, -1, 0}};
        QVERIFY(edgeLetters(fromHead, BeamAxis::plusZ, geometry).words ==
                (std::array<QString, 4>{"A", "P", QString::fromUtf8("L · probe"), "R"}));
        QVERIFY(edgeLetters(fromHead, std::nullopt, geometry).words == (std::array<QString, 4>{"A", "P", "L", "R"}));
        QVERIFY(towardsProbe(fromHead, BeamAxis::plusZ) == QPointF(0, -1));
        QVERIFY(towardsProbe(fromHead, BeamAxis::minusX) == QPointF(1, 0));
        QVERIFY(!towardsProbe(alongBeam, BeamAxis::plusZ));
        QCOMPARE(lieOf(alongBeam, BeamAxis::plusZ), QString("from the probe"));
        QCOMPARE(lieOf(alongBeam, BeamAxis::minusZ), QString("towards the probe"));
        QCOMPARE(lieOf(fromHead, BeamAxis::plusZ), QString("along the beam"));
        QCOMPARE(lieOf(frameOf(Viewpoint{.azimuthDegrees = 45.0}), BeamAxis::plusZ), QString("oblique to the beam"));
        QCOMPARE(patientLetters(normalized({0.3, 1.0, 0.1})), QString("P"));  // 17 degrees aside
        QCOMPARE(patientLetters(normalized({0.5, -1.0, 0.1})), QString("AL"));
        QCOMPARE(patientLetters(normalized({-1.0, 0.9, -0.8})), QString("RPF"));
    }

private:
    void takeSide(int number) {
        QTest::keyClick(&window(), static_cast<Qt::Key>(Qt::Key_0 + number), Qt::ControlModifier);
        window().document().change("no front", [](Document& next) { next.scene.front = {}; });
        waitUntilIdle();
    }
    /// Takes a side by its key, without its front. Fails if the picture shows one of its four corners elsewhere.
    void verifyTheSidesCorners(int number) {
        takeSide(number);
        // From the probe, from behind, onto the plane A and its back, along it from the left and from the right.
        const ViewFrame probe = frameOf(Viewpoint{.beamAxis = document().beam.axis});
        const std::array<Vec3, 6> outwards{-probe.forward, probe.forward, probe.down,
                                           -probe.down,    -probe.right,  probe.right};
        const Vec3 outward = outwards[static_cast<std::size_t>(number - 1)];
        const QImage picture = window().volumeView().convergedImage();
        Vec3 rightwards(0, 0, 0), downwards(0, 0, 0);
        int seen = 0;
        for (int corner = 0; corner < 8; ++corner) {
            const Vec3 fromCentre = at(corner) - dataBox().centreMm();
            if (outward.dot(fromCentre) < 0) continue;
            const QPoint pixel = seenIn3d(at(corner));
            QCOMPARE(valueAt(picture, pixel), cornerValue(corner));
            rightwards += fromCentre * (pixel.x() > window().volumeView().width() / 2 ? 1 : -1);
            downwards += fromCentre * (pixel.y() > window().volumeView().height() / 2 ? 1 : -1);
            ++seen;
        }
        QVERIFY2(seen == 4, qPrintable(QString("Ctrl+%1").arg(number)));
        QVERIFY2(normalized(rightwards).cross(normalized(downwards)).dot(-outward) > 0.99, "the picture is mirrored");
    }

    Vec3 at(int corner) { return cornerMm(window().openStudy().volume()->geometry(), corner); }
    /// The brightness of the picture at a place of the widget; a picture may have more pixels than that.
    int valueAt(const QImage& picture, const QPoint& place) {
        const QSize size = window().volumeView().size();
        return qGray(
            picture.pixel(place.x() * picture.width() / size.width(), place.y() * picture.height() / size.height()));
    }

    QString m_file;
};

ECHOLUCENT_TEST_CLASS(TestMarkedCorners)

#include "test_marked_corners.moc"
