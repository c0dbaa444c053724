// The scene in a window as the program shows it: OpenGL belongs to Qt there, and depths are read between drawings.
#include <QVTKOpenGLWindow.h>
#include <vtkActor.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>
#include <QTest>

#include <QApplication>
#include <cmath>

#include "tests/qt_program/test_classes.h"
#include "tests/volume_view/drawn_scene.h"
#include "widgets/volume_view/volume_view_widget.h"

using namespace echolucent;
using namespace echolucent::testing;

class SceneInWindowTest : public QObject {
    Q_OBJECT

private slots:
    void depthIsReadBetweenDrawings() {
        const auto volume = ballInTheCorner();
        VolumeScene scene;
        vtkNew<vtkGenericOpenGLRenderWindow> renderWindow;
        QVTKOpenGLWindow window(renderWindow.Get());
        scene.setVolume(volume);
        renderWindow->AddRenderer(scene.renderer());
        vtkNew<vtkActor> ball = sphereAt(volume->geometry().centreMm(), 6, {0, 1, 0}, 128);
        scene.renderer()->AddActor(ball);
        const Camera camera = cameraOn(*volume, {});
        QVERIFY(!scene.opaqueDepth(camera, 100, 100));  // nowhere to draw yet, and no crash

        window.resize(200, 160);
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        QVERIFY(QTest::qWaitFor([&] { return window.isValid(); }));
        scene.show(std::make_shared<const ScreenPicture>(plainPicture(200, 160, {0, 0, 0, 0})), camera);
        const QImage before = screen(window, *renderWindow);
        QVERIFY(qGreen(before.pixel(100, 80)) == 255);

        std::shared_ptr<const DepthMap> first;
        for (int i = 0; i < 2; ++i) {
            window.doneCurrent();
            const auto map = scene.opaqueDepth(camera, 100, 100);
            QVERIFY(map);
            if (i == 0) first = map;
            QCOMPARE(map, first);  // nothing changed, so nothing was read again
            const double front = volume->geometry().centreMm()[2] - 6;
            QVERIFY(std::abs(map->depthMm[50 * 100 + 50] - front) < 0.05);
            QVERIFY(std::isinf(map->depthMm[2 * 100 + 2]));
            QCOMPARE(screen(window, *renderWindow), before);
        }
        QVERIFY(!scene.openGlRenderer().empty());
        renderWindow->RemoveRenderer(scene.renderer());
    }

private:
    static QImage screen(QVTKOpenGLWindow& window, vtkRenderWindow& renderWindow) {
        window.makeCurrent();
        renderWindow.Render();
        const int* size = renderWindow.GetSize();
        vtkNew<vtkUnsignedCharArray> pixels;
        renderWindow.GetPixelData(0, 0, size[0] - 1, size[1] - 1, 0, pixels.Get(), 0);
        return QImage(pixels->GetPointer(0), size[0], size[1], 3 * size[0], QImage::Format_RGB888).mirrored();
    }
};

ECHOLUCENT_TEST_CLASS(SceneInWindowTest)
#include "test_scene_in_window.moc"
