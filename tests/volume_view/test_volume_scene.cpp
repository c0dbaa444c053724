// The scene is drawn off screen by VTK alone, without a QApplication.
#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPiecewiseFunction.h>
#include <vtkRenderer.h>
#include <vtkVolume.h>
#include <vtkVolumeProperty.h>
#include <QTest>

#include <array>
#include <cmath>

#include "processing/ray_caster/ray_caster.h"
#include "tests/qt_program/test_classes.h"
#include "tests/volume_view/drawn_scene.h"
#include "widgets/volume_view/scene/graphics_card/vtk_volume_image.h"
#include "widgets/volume_view/scene/vtk_camera.h"

using namespace echolucent;
using namespace echolucent::testing;

namespace {

/// Different in every pixel, half transparent in places.
ScreenPicture speckledPicture(int width, int height) {
    ScreenPicture picture;
    picture.width = width;
    picture.height = height;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const int alpha = 55 + (x * 37 + y * 91) % 200;
            picture.rgba.insert(
                picture.rgba.end(),
                {static_cast<std::uint8_t>(alpha * (x % 5) / 5), static_cast<std::uint8_t>(alpha * (y % 7) / 7),
                 static_cast<std::uint8_t>(alpha * ((x + y) % 3) / 3), static_cast<std::uint8_t>(alpha)});
        }
    }
    return picture;
}

}  // namespace

class VolumeSceneTest : public QObject {
    Q_OBJECT

private slots:
    void aPictureOfTheWindowsSizeIsDrawnPixelByPixel() {
        DrawnScene drawn(97, 61);
        const auto volume = ballInTheCorner();
        drawn.scene.setVolume(volume);
        const auto picture = std::make_shared<const ScreenPicture>(speckledPicture(97, 61));
        drawn.scene.show(picture, cameraOn(*volume, {}));
        drawn.draw();
        for (int y = 0; y < 61; ++y) {
            for (int x = 0; x < 97; ++x) {
                const std::size_t offset = 4 * (static_cast<std::size_t>(y) * 97 + static_cast<std::size_t>(x));
                const Level expected{picture->rgba[offset], picture->rgba[offset + 1], picture->rgba[offset + 2]};
                QVERIFY2(drawn.at(x, y) == expected, qPrintable(QString("pixel %1, %2").arg(x).arg(y)));
            }
        }
    }

    void aNewerPictureReplacesTheOlder() {
        DrawnScene drawn(40, 40);
        const auto volume = ballInTheCorner();
        drawn.scene.setVolume(volume);
        for (const std::uint8_t level : {50, 200}) {
            drawn.scene.show(std::make_shared<const ScreenPicture>(plainPicture(40, 40, {level, 0, 0, 255})),
                             cameraOn(*volume, {}));
            drawn.draw();
            QCOMPARE(drawn.at(20, 20), (Level{level, 0, 0}));
        }
    }

    void aCoarsePictureFillsTheWindow() {
        DrawnScene drawn(90, 60);
        const auto volume = ballInTheCorner();
        drawn.scene.setVolume(volume);
        ScreenPicture halves = plainPicture(30, 20, {255, 0, 0, 255});
        for (std::size_t i = 0; i < 30 * 10; ++i)
            halves.rgba[4 * i] = 0, halves.rgba[4 * i + 1] = 255;  // upper half green
        drawn.scene.show(std::make_shared<const ScreenPicture>(halves), cameraOn(*volume, {}));
        drawn.draw();
        for (const int x : {0, 45, 89}) {
            QCOMPARE(drawn.at(x, 0), (Level{0, 255, 0}));
            QCOMPARE(drawn.at(x, 27), (Level{0, 255, 0}));
            QCOMPARE(drawn.at(x, 32), (Level{255, 0, 0}));
            QCOMPARE(drawn.at(x, 59), (Level{255, 0, 0}));
        }
    }

    void aPictureOfAnotherShapeKeepsItsProportions() {
        DrawnScene drawn(100, 50);
        const auto volume = ballInTheCorner();
        drawn.scene.setVolume(volume);
        drawn.scene.show(std::make_shared<const ScreenPicture>(plainPicture(50, 50, {255, 255, 255, 255})),
                         cameraOn(*volume, {}));
        drawn.draw();
        QCOMPARE(drawn.at(24, 25), (Level{0, 0, 0}));
        QCOMPARE(drawn.at(25, 25), (Level{255, 255, 255}));
        QCOMPARE(drawn.at(74, 0), (Level{255, 255, 255}));
        QCOMPARE(drawn.at(75, 0), (Level{0, 0, 0}));
    }

    void castVolumeAndVtkActorLieInTheSamePlace_data() {
        QTest::addColumn<Projection>("projection");
        QTest::addColumn<Viewpoint>("view");
        for (const Projection projection : {Projection::parallel, Projection::perspective}) {
            const char* name = projection == Projection::parallel ? "parallel" : "perspective";
            QTest::addRow("%s +z", name) << projection << Viewpoint{};
            QTest::addRow("%s +y turned", name) << projection << Viewpoint{BeamAxis::plusY, 35, -20, 0};
            QTest::addRow("%s rolled", name) << projection << Viewpoint{BeamAxis::minusX, -10, 50, 65};
        }
    }
    void castVolumeAndVtkActorLieInTheSamePlace() {
        QFETCH(Projection, projection);
        QFETCH(Viewpoint, view);
        // A ball of voxels and VTK's ball of the same place and radius, anisotropic spacing, off the middle.
        const VolumeGeometry geometry = geometryOf(60, 50, 30, {1, 1, 2});
        const Vec3 centre{15, 17, 20};
        const auto volume = volumeOf(geometry, [&](double x, double y, double z) {
            return length(Vec3{x, y, 2 * z} - centre) <= 9 ? 255 : 0;
        });
        DrawnScene drawn(200, 200);
        drawn.scene.setVolume(volume);
        RayCastSettings settings;
        settings.width = settings.height = 200;
        settings.camera = cameraOn(*volume, view, projection);
        settings.step = 0.5;
        settings.colourMap = ColourMap::grey;
        const OpacityCurve wall = ManualCurve{{{0.49, 0.0}, {0.5, 1.0}}};
        const auto picture = castRays(*volume, wall, settings);
        QVERIFY(picture);
        drawn.scene.show(std::make_shared<const ScreenPicture>(screenPicture(*picture)), settings.camera);
        drawn.draw();
        const cv::Vec3d cast = centreAndArea(drawn, [](const Level& level) { return level[0] > 60; });

        vtkNew<vtkActor> ball = sphereAt(centre, 9, {0, 1, 0});
        drawn.scene.renderer()->AddActor(ball);
        drawn.scene.show(std::make_shared<const ScreenPicture>(plainPicture(200, 200, {0, 0, 0, 0})), settings.camera);
        drawn.draw();
        const cv::Vec3d drawnByVtk = centreAndArea(drawn, [](const Level& level) { return level[1] > 60; });
        QVERIFY(drawnByVtk[2] > 300);
        QVERIFY2(std::hypot(cast[0] - drawnByVtk[0], cast[1] - drawnByVtk[1]) < 0.6,
                 qPrintable(
                     QString("%1, %2 against %3, %4").arg(cast[0]).arg(cast[1]).arg(drawnByVtk[0]).arg(drawnByVtk[1])));
        QVERIFY(std::abs(std::sqrt(cast[2] / drawnByVtk[2]) - 1) < 0.06);
    }

    void opaqueActorBeforeTheVolumeCoversIt() {
        DrawnScene drawn(60, 60);
        const auto volume = ballInTheCorner();
        drawn.scene.setVolume(volume);
        const Vec3 centre = volume->geometry().centreMm();
        vtkNew<vtkActor> before = sphereAt(centre - Vec3{0, 0, 30}, 4, {0, 0, 1});
        drawn.scene.renderer()->AddActor(before);
        drawn.scene.show(std::make_shared<const ScreenPicture>(plainPicture(60, 60, {128, 0, 0, 128})),
                         cameraOn(*volume, {}));
        drawn.draw();
        QCOMPARE(drawn.at(30, 30), (Level{0, 0, 255}));
        QCOMPARE(drawn.at(2, 2), (Level{128, 0, 0}));
    }

    void opaqueActorBehindTheVolumeShinesThrough() {
        DrawnScene drawn(60, 60);
        const auto volume = ballInTheCorner();
        drawn.scene.setVolume(volume);
        const Vec3 centre = volume->geometry().centreMm();
        vtkNew<vtkActor> behind = sphereAt(centre + Vec3{0, 0, 30}, 4, {0, 0, 1});
        drawn.scene.renderer()->AddActor(behind);
        drawn.scene.show(std::make_shared<const ScreenPicture>(plainPicture(60, 60, {128, 0, 0, 128})),
                         cameraOn(*volume, {}));
        drawn.draw();
        const Level seen = drawn.at(30, 30);
        QVERIFY(std::abs(seen[0] - 128) <= 1 && seen[1] == 0 && std::abs(seen[2] - 127) <= 1);  // 1 - 128/255 of blue
    }

    void camerasRoundTrip_data() { castVolumeAndVtkActorLieInTheSamePlace_data(); }
    void camerasRoundTrip() {
        QFETCH(Projection, projection);
        QFETCH(Viewpoint, view);
        const Camera ours = cameraOn(*ballInTheCorner(), view, projection);
        vtkNew<vtkCamera> vtk;
        setCamera(*vtk, ours);
        const Camera back = cameraOf(*vtk);
        QVERIFY(length(back.focalPoint - ours.focalPoint) < 1e-9);
        QVERIFY(length(back.frame.right - ours.frame.right) < 1e-12);
        QVERIFY(length(back.frame.down - ours.frame.down) < 1e-12);
        QVERIFY(length(back.frame.forward - ours.frame.forward) < 1e-12);
        QCOMPARE(back.projection, ours.projection);
        QCOMPARE(back.heightMm, ours.heightMm);
        QCOMPARE(back.distanceMm, ours.distanceMm);
        QCOMPARE(back.viewAngleDegrees, ours.viewAngleDegrees);
    }

    void vtkSeesTheVolumesOwnMemory() {
        const auto volume = ballInTheCorner({0.5, 0.25, 2});
        const auto image = imageOn(*volume);
        QCOMPARE(image->GetScalarPointer(), static_cast<const void*>(std::get<0>(volume->voxels()).data()));
        QCOMPARE(image->GetScalarComponentAsDouble(11, 9, 8, 0),
                 volume->storedValue(volume->geometry().offset(11, 9, 8)));
        const double* bounds = image->GetBounds();
        QCOMPARE(bounds[1], 39 * 0.5);
        QCOMPARE(bounds[3], 35 * 0.25);
        QCOMPARE(bounds[5], 31 * 2.0);
    }

    void pickersReadTheCurveOnStoredValues() {
        VolumeScene scene;
        const auto volume =
            std::make_shared<const Volume>(geometryOf(2, 1, 1), std::vector<std::uint16_t>{0, 4000}, 4000.0);
        scene.setVolume(volume);
        scene.setTransfer(PowerCurve{2, 1.0}, ColourMap::grey);
        vtkPiecewiseFunction* opacity = scene.volumeProp()->GetProperty()->GetScalarOpacity();
        QVERIFY(std::abs(opacity->GetValue(2000) - 0.25) < 1e-4);
        QVERIFY(std::abs(opacity->GetValue(4000) - 1.0) < 1e-12);
    }

    void roundLengths_data() {
        QTest::addColumn<double>("limit");
        QTest::addColumn<double>("mm");
        QTest::addColumn<QString>("text");
        QTest::newRow("10") << 10.0 << 10.0 << "10 mm";
        QTest::newRow("19.9") << 19.9 << 10.0 << "10 mm";
        QTest::newRow("20") << 20.0 << 20.0 << "20 mm";
        QTest::newRow("73") << 73.0 << 50.0 << "50 mm";
        QTest::newRow("0.7") << 0.7 << 0.5 << "0.5 mm";
        QTest::newRow("0.1") << 0.1 << 0.1 << "0.1 mm";
        QTest::newRow("0.0034") << 0.0034 << 0.002 << "0.002 mm";
        QTest::newRow("1234") << 1234.0 << 1000.0 << "1000 mm";
    }
    void roundLengths() {
        QFETCH(double, limit);
        QFETCH(double, mm);
        QFETCH(QString, text);
        const RoundLength length = roundLengthUpTo(limit);
        QVERIFY(std::abs(length.mm - mm) < 1e-12);
        QCOMPARE(QString::fromStdString(length.text), text);
    }

    void scaleBarHasTheLengthItSays() {
        DrawnScene drawn(400, 300);
        const auto volume = ballInTheCorner();
        drawn.scene.setVolume(volume);
        drawn.scene.setAnnotationsVisible(true);
        Camera camera = cameraOn(*volume, {});
        camera.heightMm = 60;  // 5 pixels a millimetre
        drawn.scene.show(std::make_shared<const ScreenPicture>(plainPicture(400, 300, {0, 0, 0, 0})), camera);
        drawn.draw();
        QCOMPARE(drawn.scene.scaleBar().text(), std::string("10 mm"));
        // The bar's own row is the longest run of light pixels in the lower right.
        int longest = 0;
        for (int y = 250; y < 300; ++y) {
            int run = 0;
            for (int x = 200; x < 400; ++x) longest = std::max(longest, run = drawn.at(x, y)[0] > 150 ? run + 1 : 0);
        }
        QVERIFY2(std::abs(longest - 51) <= 2, qPrintable(QString::number(longest)));
    }

    void noLengthIsClaimedWhereSpacingIsUnknown() {
        DrawnScene drawn(400, 300);
        VolumeGeometry geometry = geometryOf(20, 20, 20);
        geometry.spacingKnown = false;
        const auto volume = volumeOf(geometry, [](double, double, double) { return 100; });
        drawn.scene.setVolume(volume);
        drawn.scene.setAnnotationsVisible(true);
        drawn.scene.show(std::make_shared<const ScreenPicture>(plainPicture(400, 300, {0, 0, 0, 0})),
                         cameraOn(*volume, {}));
        drawn.draw();
        QVERIFY(drawn.scene.scaleBar().text().find("spacing unknown") == 0);
        QVERIFY(drawn.scene.scaleBar().text().find("mm") == std::string::npos);
        QCOMPARE(drawn.scene.scaleBar().lengthPixels(), 0.0);
        int lit = 0;
        for (int y = 240; y < 300; ++y)
            for (int x = 200; x < 400; ++x) lit += drawn.at(x, y)[0] > 150;
        QVERIFY2(lit > 100, qPrintable(QString::number(lit)));  // the words are on the screen
    }

    void markerShowsTheGridsAxes() {
        // Looking along +z, x goes right and y down.
        const ViewFrame frame = frameOf({});
        QCOMPARE(seenFrom(frame, {1, 0, 0}), (Vec3{1, 0, 0}));
        QCOMPARE(seenFrom(frame, {0, 1, 0}), (Vec3{0, -1, 0}));
        QCOMPARE(seenFrom(frame, {0, 0, 1}), (Vec3{0, 0, -1}));

        DrawnScene drawn(200, 200);
        const auto volume = ballInTheCorner();
        drawn.scene.setVolume(volume);
        drawn.scene.setAnnotationsVisible(true);
        drawn.scene.show(std::make_shared<const ScreenPicture>(plainPicture(200, 200, {0, 0, 0, 0})),
                         cameraOn(*volume, {}));
        drawn.draw();
        const int foot = 68;  // margin + arm + letter
        const Level alongX = drawn.at(foot + 20, 199 - foot), alongY = drawn.at(foot, 199 - foot + 20);
        QVERIFY(alongX[0] > alongX[1] + 40);  // red to the right
        QVERIFY(alongY[1] > alongY[0] + 20);  // green downwards
        QCOMPARE(drawn.at(foot - 20, 199 - foot), (Level{0, 0, 0}));
    }

    void anEmptySceneIsBlack() {
        DrawnScene drawn(50, 40);
        drawn.scene.setAnnotationsVisible(true);
        drawn.draw();
        for (int y = 0; y < 40; ++y)
            for (int x = 0; x < 50; ++x) QCOMPARE(drawn.at(x, y), (Level{0, 0, 0}));
        const auto volume = ballInTheCorner();
        drawn.scene.setVolume(volume);
        drawn.scene.show(std::make_shared<const ScreenPicture>(plainPicture(50, 40, {255, 255, 255, 255})),
                         cameraOn(*volume, {}));
        drawn.scene.setVolume(nullptr);
        drawn.draw();
        QCOMPARE(drawn.at(25, 20), (Level{0, 0, 0}));
    }

private:
    template <typename Belongs>
    static cv::Vec3d centreAndArea(DrawnScene& drawn, const Belongs& belongs) {
        double x = 0, y = 0, count = 0;
        for (int row = 0; row < drawn.height(); ++row) {
            for (int column = 0; column < drawn.width(); ++column) {
                if (!belongs(drawn.at(column, row))) continue;
                x += column, y += row, ++count;
            }
        }
        return {x / count, y / count, count};
    }
};

ECHOLUCENT_TEST_CLASS(VolumeSceneTest)
#include "test_volume_scene.moc"
