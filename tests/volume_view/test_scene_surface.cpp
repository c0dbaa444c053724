// The volume's surface in VTK's depth buffer, and who finds it.
#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkHardwareSelector.h>
#include <vtkPropPicker.h>
#include <vtkVolume.h>
#include <vtkWorldPointPicker.h>
#include <QTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "tests/qt_program/test_classes.h"
#include "tests/volume_view/drawn_scene.h"
#include "widgets/volume_view/scene/ray_cast_mapper.h"

using namespace echolucent;
using namespace echolucent::testing;

namespace {

RayCastMapper* mapperOf(VolumeScene& scene) { return RayCastMapper::SafeDownCast(scene.volumeProp()->GetMapper()); }

/// A picture with a tilted surface in its left half: depth by column, none in the right half.
ScreenPicture tiltedSurface(int edge, double nearest, double mmPerColumn) {
    ScreenPicture picture = plainPicture(edge, edge, {200, 0, 0, 255});
    for (int y = 0; y < edge; ++y) {
        for (int x = 0; x < edge; ++x) {
            picture.depthMm.push_back(x < edge / 2 ? static_cast<float>(nearest + mmPerColumn * x)
                                                   : std::numeric_limits<float>::infinity());
            if (x >= edge / 2)
                std::fill_n(&picture.rgba[4 * static_cast<std::size_t>(y * edge + x)], 4, std::uint8_t{0});
        }
    }
    return picture;
}

/// A depth of the window, 0 on the camera's near clipping plane and 1 on the far one, as a depth along the view, mm
/// from the grid origin.
double mmOf(vtkCamera& camera, double windowDepth) {
    const double eye = Vec3(camera.GetPosition()).dot(normalized(Vec3(camera.GetDirectionOfProjection())));
    const double near = camera.GetClippingRange()[0], far = camera.GetClippingRange()[1];
    if (camera.GetParallelProjection()) return eye + near + windowDepth * (far - near);
    return eye + near * far / (far - windowDepth * (far - near));
}

}  // namespace

class SceneSurfaceTest : public QObject {
    Q_OBJECT

private slots:
    void anUnchangedSceneIsNotHandedOverAgain() {
        const auto volume = ballInTheCorner();
        DrawnScene drawn(50, 50);
        drawn.scene.setVolume(volume);
        const auto picture = std::make_shared<const ScreenPicture>(tiltedSurface(50, 3, 0.2));
        const OpacityCurve curve = PowerCurve{2, 1.0};
        vtkMTimeType shown = 0;
        for (int i = 0; i < 3; ++i) {
            drawn.scene.setTransfer(curve, ColourMap::sepia);
            drawn.scene.show(picture, cameraOn(*volume, {}));
            drawn.draw();
            if (i == 0) shown = mapperOf(drawn.scene)->GetMTime();
            QCOMPARE(mapperOf(drawn.scene)->GetMTime(), shown);
        }
        const auto other = std::make_shared<const ScreenPicture>(*picture);
        drawn.scene.show(other, cameraOn(*volume, {}));
        QVERIFY(mapperOf(drawn.scene)->GetMTime() > shown);
    }

    void firstHitDepthIsInTheDepthBuffer_data() { projections(); }
    void firstHitDepthIsInTheDepthBuffer() {
        QFETCH(Viewpoint, view);
        QFETCH(Projection, projection);
        constexpr int size = 64;
        const auto volume = ballInTheCorner();
        const Camera camera = cameraOn(*volume, view, projection);
        const double middle = camera.frame.forward.dot(camera.focalPoint);
        DrawnScene drawn(size, size);
        drawn.scene.setVolume(volume);
        const auto picture = std::make_shared<const ScreenPicture>(tiltedSurface(size, middle - 10, 0.3));
        drawn.scene.show(picture, camera);
        drawn.draw();
        vtkCamera& vtk = *drawn.scene.renderer()->GetActiveCamera();
        vtkNew<vtkWorldPointPicker> picker;
        for (const int y : {0, 20, 63}) {
            for (int x = 0; x < size; ++x) {
                const double depth = drawn.windowDepthAt(x, y);
                if (x >= size / 2) {
                    QCOMPARE(depth, 1.0);
                    continue;
                }
                // The buffer has at least 24 bits; a shader's floats lose a few of them on the way.
                const double tolerance = 0.001 + 16 * (mmOf(vtk, depth + 6e-8) - mmOf(vtk, depth));
                const double expected = picture->depthMm[static_cast<std::size_t>(y * size + x)];
                QVERIFY2(tolerance < 0.01, qPrintable(QString::number(tolerance)));
                QVERIFY2(std::abs(mmOf(vtk, depth) - expected) < tolerance,
                         qPrintable(QString("%1 instead of %2").arg(mmOf(vtk, depth)).arg(expected)));
                picker->Pick(x, size - 1 - y, 0, drawn.scene.renderer());
                QVERIFY(std::abs(camera.frame.forward.dot(Vec3(picker->GetPickPosition())) - expected) < 0.02);
            }
        }
    }

    void withoutDepthsTheDepthBufferStaysAsItWas() {
        const auto volume = ballInTheCorner();
        DrawnScene drawn(40, 40);
        drawn.scene.setVolume(volume);
        drawn.scene.show(std::make_shared<const ScreenPicture>(plainPicture(40, 40, {90, 90, 90, 255})),
                         cameraOn(*volume, {}));
        drawn.draw();
        QCOMPARE(drawn.windowDepthAt(20, 20), 1.0);
    }

    void pickersFindTheVolumeOrTheActorThatIsSeen() {
        const auto volume = ballInTheCorner();
        const Vec3 centre = volume->geometry().centreMm();
        DrawnScene drawn(64, 64);
        drawn.scene.setVolume(volume);
        vtkNew<vtkActor> ball = sphereAt(centre, 6, {0, 1, 0});
        drawn.scene.renderer()->AddActor(ball);
        // Left half: a surface, before the ball, then behind it; right half: the ball alone.
        for (const double surface : {5.0, 12.0}) {
            ScreenPicture picture = tiltedSurface(64, surface, 0.0);
            drawn.scene.show(std::make_shared<const ScreenPicture>(std::move(picture)), cameraOn(*volume, {}));
            drawn.draw();
            vtkProp* const inFront = surface < 9 ? static_cast<vtkProp*>(drawn.scene.volumeProp()) : ball.Get();
            QCOMPARE(selectedAt(drawn, 30, 32), inFront);
            QCOMPARE(selectedAt(drawn, 33, 32), static_cast<vtkProp*>(ball.Get()));
            QCOMPARE(selectedAt(drawn, 4, 4), static_cast<vtkProp*>(drawn.scene.volumeProp()));
            QCOMPARE(selectedAt(drawn, 60, 4), static_cast<vtkProp*>(nullptr));
            vtkNew<vtkPropPicker> picker;
            picker->PickProp(30, 64 - 1 - 32, drawn.scene.renderer());
            QCOMPARE(picker->GetViewProp(), inFront);
            // Selecting draws ids; what is on the screen afterwards is the picture again.
            drawn.draw();
            QCOMPARE(drawn.at(4, 4), (Level{200, 0, 0}));
        }
    }

private:
    static void projections() {
        QTest::addColumn<Viewpoint>("view");
        QTest::addColumn<Projection>("projection");
        QTest::newRow("parallel +z") << Viewpoint{} << Projection::parallel;
        QTest::newRow("parallel turned") << Viewpoint{BeamAxis::minusY, 35, -20, 15} << Projection::parallel;
        QTest::newRow("perspective +x") << Viewpoint{BeamAxis::plusX, 0, 0, 0} << Projection::perspective;
        QTest::newRow("perspective turned") << Viewpoint{BeamAxis::minusX, 30, 40, 15} << Projection::perspective;
    }

    static vtkProp* selectedAt(DrawnScene& drawn, int x, int y) {
        const auto column = static_cast<unsigned>(x), row = static_cast<unsigned>(drawn.height() - 1 - y);
        vtkNew<vtkHardwareSelector> selector;
        selector->SetRenderer(drawn.scene.renderer());
        selector->SetArea(column, row, column, row);
        selector->SetFieldAssociation(vtkDataObject::FIELD_ASSOCIATION_CELLS);
        if (!selector->CaptureBuffers()) return nullptr;
        const std::array<unsigned, 2> at{column, row};
        return selector->GetPixelInformation(at.data()).Prop;
    }
};

ECHOLUCENT_TEST_CLASS(SceneSurfaceTest)
#include "test_scene_surface.moc"
