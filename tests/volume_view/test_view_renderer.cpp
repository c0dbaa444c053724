// Who renders the 3D view, and what else stands in its scene.
#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkRenderer.h>
#include <vtkSphereSource.h>

#include <QApplication>
#include <QSignalSpy>
#include <QTest>
#include <cmath>

#include "tests/qt_program/test_classes.h"
#include "tests/volume_view/shown_view.h"
#include "widgets/volume_view/scene/volume_scene.h"

using namespace echolucent;
using namespace echolucent::testing;

class ViewRendererTest : public QObject {
    Q_OBJECT

private slots:
    void whereOpenGlIsSoftwareTheRayCasterRenders() {
        ShownView s;
        QVERIFY(s.ready);
        if (s.view.graphicsCardUsable()) QSKIP("a graphics card is at hand");
        QCOMPARE(s.view.rendererName(), "software renderer");
        QVERIFY2(s.view.rendererRemark().contains("OpenGL is software"), qPrintable(s.view.rendererRemark()));
    }

    void whatOpenGlDrawsByItselfIsThePictureToo() {
        // Software OpenGL is slow, but draws what a graphics card does.
        ShownView s;
        QVERIFY(s.ready);
        const QImage cast = s.view.screenImage();
        QList<PictureReport> reports;
        connect(&s.view, &VolumeViewWidget::pictureDelivered, this, [&](const PictureReport& r) { reports << r; });
        s.view.setRenderer(RendererChoice::graphicsCard);
        QTRY_COMPARE_WITH_TIMEOUT(s.view.rendererName(), "graphics card", patience);
        QVERIFY(s.awaitIdle());
        QVERIFY(s.view.pictureIsCurrent() && !s.view.picture());
        QCOMPARE(reports.size(), 1);
        QVERIFY(reports[0].converged && reports[0].castMilliseconds > 0);
        const QImage drawn = s.view.screenImage();
        QCOMPARE(drawn.size(), cast.size());
        double sum = 0, difference = 0;
        for (int y = 0; y < 140; ++y)
            for (int x = 0; x < drawn.width(); ++x) {
                sum += qRed(cast.pixel(x, y));
                difference += std::abs(qRed(drawn.pixel(x, y)) - qRed(cast.pixel(x, y)));
            }
        QVERIFY2(difference < 0.05 * sum, qPrintable(QString("%1 of %2").arg(difference).arg(sum)));
        // It follows, and an unchanged view is not drawn again.
        s.view.setNearCut(16);
        QVERIFY(s.awaitIdle());
        QCOMPARE(reports.size(), 2);
        s.view.setNearCut(16);
        QTRY_VERIFY_WITH_TIMEOUT(!s.view.busy(), patience);
        QCOMPARE(reports.size(), 2);
        QVERIFY(s.view.screenImage() != drawn);
        s.view.setNearCut(0);
        s.view.setRenderer(RendererChoice::software);
        QTRY_VERIFY_WITH_TIMEOUT(s.view.picture() && s.awaitIdle(), patience);
        QCOMPARE(s.view.rendererName(), "software renderer");
        QCOMPARE(s.view.screenImage(), cast);
        disconnect(&s.view, &VolumeViewWidget::pictureDelivered, this, nullptr);
    }

    void raysEndAtWhatStandsInTheScene() {
        ShownView s;
        QVERIFY(s.ready);
        const auto before = s.view.picture();
        vtkNew<vtkSphereSource> sphere;
        sphere->SetCenter(11, 9, -2);  // before the ball, where it sticks out of the volume's front
        sphere->SetRadius(3);
        vtkNew<vtkPolyDataMapper> mapper;
        mapper->SetInputConnection(sphere->GetOutputPort());
        vtkNew<vtkActor> actor;
        actor->SetMapper(mapper);
        s.view.scene().renderer()->AddActor(actor);
        s.view.sceneChanged();
        QVERIFY(s.awaitIdle());
        const RayCastSettings settings = s.view.settings();
        const double pixels = settings.height / settings.camera.heightMm;
        const Vec3 seen = Vec3(11, 9, -2) - settings.camera.focalPoint;
        const int x = static_cast<int>(settings.width / 2.0 + seen.dot(settings.camera.frame.right) * pixels);
        const int y = static_cast<int>(settings.height / 2.0 + seen.dot(settings.camera.frame.down) * pixels);
        const auto alphaAt = [&](const Picture& picture) {
            return picture.rgba[4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
                                     static_cast<std::size_t>(x)) +
                                3];
        };
        QVERIFY(alphaAt(*before) > 0.9F);
        QCOMPARE(alphaAt(*s.view.picture()), 0.0F);
        QVERIFY(s.view.pictureIsCurrent());
        const QRgb onScreen = s.view.screenImage().pixel(x, y);
        QVERIFY2(qRed(onScreen) > 100 && qRed(onScreen) == qBlue(onScreen), "the sphere is grey");
        // A scene that stays the same is not cast again.
        QSignalSpy deliveries(&s.view, &VolumeViewWidget::pictureDelivered);
        s.view.sceneChanged();
        QTRY_VERIFY_WITH_TIMEOUT(!s.view.busy(), patience);
        QCOMPARE(deliveries.size(), 0);
    }
};

ECHOLUCENT_TEST_CLASS(ViewRendererTest)
#include "test_view_renderer.moc"
