// Who renders: the choice, what OpenGL says about itself, and volumes that the graphics card cannot take.
#include <vtkOpenGLRenderWindow.h>
#include <vtkVolumeProperty.h>
#include <QTest>

#include "tests/qt_program/test_classes.h"
#include "tests/volume_view/drawn_scene.h"
#include "widgets/volume_view/scene/graphics_card/vtk_volume_image.h"

using namespace echolucent;
using namespace echolucent::testing;

class RendererChoiceTest : public QObject {
    Q_OBJECT

private slots:
    void softwareIsChosenWhereOpenGlIsSoftware() {
        DrawnScene drawn(40, 40);
        QCOMPARE(drawn.scene.rendererInUse(), RendererChoice::software);  // nothing known yet
        QVERIFY(drawn.scene.openGlRenderer().empty());
        drawn.draw();
        QVERIFY(!drawn.scene.openGlRenderer().empty());
        const bool software = isSoftwareOpenGl(drawn.scene.openGlRenderer());
        QCOMPARE(drawn.scene.graphicsCardAtHand(), !software);
        QCOMPARE(drawn.scene.rendererInUse(), software ? RendererChoice::software : RendererChoice::graphicsCard);
        QCOMPARE(drawn.scene.whySoftware().empty(), !software);
        drawn.scene.setRenderer(RendererChoice::graphicsCard);
        QCOMPARE(drawn.scene.rendererInUse(), RendererChoice::graphicsCard);
        RayCastSettings look;
        look.clippingPlanes.resize(9);
        QCOMPARE(drawn.scene.rendererFor(look), RendererChoice::software);
        QVERIFY(!drawn.scene.whySoftware(look).empty());
        drawn.scene.setRenderer(RendererChoice::software);
        QCOMPARE(drawn.scene.rendererInUse(), RendererChoice::software);
        QVERIFY(drawn.scene.whySoftware().empty());  // it was the choice
    }

    void softwareOpenGlIsKnownByName_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<bool>("software");
        QTest::newRow("llvmpipe") << "llvmpipe (LLVM 15.0.6, 256 bits)" << true;
        QTest::newRow("softpipe") << "softpipe" << true;
        QTest::newRow("SWR") << "SWR (LLVM 11.0.1, 256 bits)" << true;
        QTest::newRow("SwiftShader")
            << "ANGLE (Google, Vulkan 1.3.0 (SwiftShader Device (Subzero)), SwiftShader driver)" << true;
        QTest::newRow("Software Rasterizer") << "Software Rasterizer" << true;
        QTest::newRow("Intel") << "Mesa Intel(R) UHD Graphics 620 (KBL GT2)" << false;
        QTest::newRow("AMD") << "AMD Radeon RX 6700 XT (radeonsi, navi22, LLVM 15.0.6, DRM 3.49)" << false;
        QTest::newRow("NVIDIA") << "NVIDIA GeForce RTX 3060/PCIe/SSE2" << false;
        QTest::newRow("Apple") << "Apple M1" << false;
    }
    void softwareOpenGlIsKnownByName() {
        QFETCH(QString, name);
        QFETCH(bool, software);
        QCOMPARE(isSoftwareOpenGl(name.toStdString()), software);
    }

    void aVolumeThatDoesNotFitIsLeftToTheRayCasterWithItsReason() {
        const GraphicsCard card{"card", 2048, std::int64_t{100} << 20};
        VolumeGeometry geometry = geometryOf(2048, 10, 10);
        QVERIFY(whyTooLarge(geometry, 1000, card).empty());
        geometry.size[1] = 2049;
        QVERIFY(whyTooLarge(geometry, 1000, card).find("2049") != std::string::npos);
        geometry.size[1] = 10;
        QVERIFY(whyTooLarge(geometry, std::int64_t{101} << 20, card).find("101 MB") != std::string::npos);
        QVERIFY(whyTooLarge(geometry, std::int64_t{101} << 20, GraphicsCard{"silent", 2048, -1}).empty());

        // The real one: longer than any card's texture side.
        const auto volume = volumeOf(geometryOf(40000, 1, 1), [](double, double, double) { return 100; });
        DrawnScene drawn(40, 40);
        drawn.scene.setRenderer(RendererChoice::graphicsCard);
        drawn.draw();
        drawn.scene.setVolume(volume);
        QCOMPARE(drawn.scene.rendererInUse(), RendererChoice::software);
        QVERIFY(drawn.scene.whySoftware().find("40000") != std::string::npos);
        RayCastSettings settings;
        settings.camera = cameraOn(*volume, {});
        drawn.scene.show(std::make_shared<const ScreenPicture>(plainPicture(40, 40, {50, 0, 0, 255})), settings.camera);
        drawn.draw();
        QCOMPARE(drawn.at(20, 20), (Level{50, 0, 0}));
        drawn.scene.setVolume(ballInTheCorner());
        QCOMPARE(drawn.scene.rendererInUse(), RendererChoice::graphicsCard);  // the next volume fits
    }

    void aDrawingThatFailsSaysWhyAndDrawsNothing() {
        // Past the scene's own check: what it cannot know is found out when the volume is handed over.
        const auto volume = volumeOf(geometryOf(40000, 1, 1), [](double, double, double) { return 100; });
        DrawnScene drawn(40, 40);
        drawn.draw();
        GraphicsCardVolume card;
        card.setVolume(volume);
        vtkNew<vtkVolumeProperty> property;
        RayCastSettings settings;
        settings.camera = cameraOn(*volume, {});
        setTransfer(*property, *volume, PowerCurve{2, 1.0}, ColourMap::sepia);
        card.setLook(settings, *property);
        card.draw(*drawn.scene.renderer(), *vtkOpenGLRenderWindow::SafeDownCast(drawn.window));
        QVERIFY(!card.failure().empty());
        card.setVolume(ballInTheCorner());
        QVERIFY(card.failure().empty());
    }
};

ECHOLUCENT_TEST_CLASS(RendererChoiceTest)
#include "test_renderer_choice.moc"
