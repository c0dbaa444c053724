// The volume through VTK's GPU mapper, here on whatever OpenGL there is, against the software ray caster. Pictures of
// both and of their difference go into the folder that ECHOLUCENT_TEST_PICTURES names, where it is set.
#include <vtkActor.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPropPicker.h>
#include <vtkVolume.h>
#include <vtkVolumeProperty.h>
#include <QDir>
#include <QImage>
#include <QTest>

#include <array>
#include <cmath>

#include "processing/phantom/phantom.h"
#include "processing/picture/view_limits.h"
#include "processing/ray_caster/ray_caster.h"
#include "tests/qt_program/test_classes.h"
#include "tests/volume_view/drawn_scene.h"

using namespace echolucent;
using namespace echolucent::testing;

namespace {

constexpr int size = 200;

std::shared_ptr<const Volume> smallFetus(int bits = 8) {
    PhantomConfig config = defaultPhantom(PhantomScene::fetus);
    config.size = {64, 64, 64};
    config.spacing = {1.5, 1.5, 1.5};
    config.bits = bits;
    return std::make_shared<const Volume>(*makePhantom(config));
}

/// The same echoes in another type of voxel.
std::shared_ptr<const Volume> asFloat(const Volume& volume) {
    std::vector<float> voxels;
    for (std::int64_t i = 0; i < volume.geometry().voxelCount(); ++i) {
        voxels.push_back(static_cast<float>(volume.storedValue(i)));
    }
    return std::make_shared<const Volume>(volume.geometry(), std::move(voxels), volume.whiteLevel());
}

/// Only a ball in the middle of the volume is data; elsewhere lies white, which must not be seen.
std::shared_ptr<const Volume> maskedToABall(const Volume& volume) {
    const VolumeGeometry& geometry = volume.geometry();
    std::vector<std::uint8_t> voxels, mask;
    for (std::int64_t z = 0; z < geometry.size[2]; ++z)
        for (std::int64_t y = 0; y < geometry.size[1]; ++y)
            for (std::int64_t x = 0; x < geometry.size[0]; ++x) {
                const Vec3 at(static_cast<double>(x), static_cast<double>(y), static_cast<double>(z));
                const bool data = length(at - Vec3{31.5, 31.5, 31.5}) < 24;
                mask.push_back(data);
                voxels.push_back(data ? static_cast<std::uint8_t>(volume.storedValue(geometry.offset(x, y, z))) : 255);
            }
    const Volume whole(geometry, std::move(voxels));
    return std::make_shared<const Volume>(whole.withDataMask(std::move(mask)));
}

QImage imageOf(DrawnScene& drawn) {
    drawn.draw();
    return QImage(drawn.pixels->GetPointer(0), drawn.width(), drawn.height(), 3 * drawn.width(), QImage::Format_RGB888)
        .mirrored();
}

struct Difference {
    double rootMeanSquare = 0;  ///< levels, over all pixels and channels
    double mean = 0;            ///< levels, the second less the first
};

Difference differenceOf(const QImage& a, const QImage& b) {
    double squares = 0, sum = 0;
    for (int y = 0; y < a.height(); ++y) {
        for (int i = 0; i < 3 * a.width(); ++i) {
            const double difference = b.constScanLine(y)[i] - a.constScanLine(y)[i];
            squares += difference * difference;
            sum += difference;
        }
    }
    const double count = 3.0 * a.width() * a.height();
    return {std::sqrt(squares / count), sum / count};
}

/// Side by side: software, graphics card, and eight times their difference around grey.
void keepPictures(const QString& name, const QImage& software, const QImage& card) {
    const QString folder = qEnvironmentVariable("ECHOLUCENT_TEST_PICTURES");
    if (folder.isEmpty()) return;
    QImage both(3 * software.width(), software.height(), QImage::Format_RGB888);
    for (int y = 0; y < software.height(); ++y) {
        for (int i = 0; i < 3 * software.width(); ++i) {
            const int a = software.constScanLine(y)[i], b = card.constScanLine(y)[i];
            both.scanLine(y)[i] = static_cast<uchar>(a);
            both.scanLine(y)[i + 3 * software.width()] = static_cast<uchar>(b);
            both.scanLine(y)[i + 6 * software.width()] = static_cast<uchar>(std::clamp(128 + 8 * (b - a), 0, 255));
        }
    }
    QVERIFY(both.save(QDir(folder).filePath(QString(name).replace(' ', '_') + ".png")));
}

RayCastSettings settingsFor(const Volume& volume, const Viewpoint& view, Projection projection, double step) {
    RayCastSettings settings;
    settings.width = settings.height = size;
    settings.camera = cameraOn(volume, view, projection);
    settings.step = step;
    return settings;
}

/// The scene as the graphics card draws it, known to be drawn by it.
QImage throughTheCard(DrawnScene& drawn, const std::shared_ptr<const Volume>& volume, const OpacityCurve& curve,
                      const RayCastSettings& settings) {
    drawn.scene.setRenderer(RendererChoice::graphicsCard);
    drawn.scene.setVolume(volume);
    drawn.draw();
    drawn.scene.setTransfer(curve, settings.colourMap);
    if (drawn.scene.rendererFor(settings) != RendererChoice::graphicsCard) return {};
    drawn.scene.showLive(settings.camera, settings);
    const QImage image = imageOf(drawn);
    return drawn.scene.rendererFor(settings) == RendererChoice::graphicsCard ? image : QImage();
}

QImage throughTheRayCaster(DrawnScene& drawn, const std::shared_ptr<const Volume>& volume, const OpacityCurve& curve,
                           const RayCastSettings& settings) {
    drawn.scene.setVolume(volume);
    const auto picture = castRays(*volume, curve, settings);
    drawn.scene.show(std::make_shared<const ScreenPicture>(screenPicture(*picture)), settings.camera);
    return imageOf(drawn);
}

}  // namespace

class SceneGraphicsCardTest : public QObject {
    Q_OBJECT

private slots:
    void bothRenderersShowTheSame_data() {
        QTest::addColumn<std::shared_ptr<const Volume>>("volume");
        QTest::addColumn<Projection>("projection");
        QTest::addColumn<double>("step");
        QTest::addColumn<double>("tolerance");  // levels of root mean square
        const auto bytes = smallFetus();
        // With small steps what is left is where a ray's first sample lies, the last 1/255 of opacity and 8 bits; with
        // steps of a unit the samples of the two lie up to a unit apart, which in speckle is another value. At the rim
        // of the data the card knows the nearest voxel only.
        QTest::newRow("8 bit") << bytes << Projection::parallel << 0.2 << 1.0;
        QTest::newRow("12 bit") << smallFetus(12) << Projection::parallel << 0.2 << 1.0;
        QTest::newRow("float") << asFloat(*bytes) << Projection::parallel << 0.2 << 1.0;
        QTest::newRow("perspective") << bytes << Projection::perspective << 0.2 << 1.0;
        QTest::newRow("masked") << maskedToABall(*bytes) << Projection::parallel << 0.2
                                << 2.2;  // the border of VTK's mask has stairs, ours has none
        QTest::newRow("step of a unit") << bytes << Projection::parallel << 1.0 << 3.0;
    }
    void bothRenderersShowTheSame() {
        QFETCH(std::shared_ptr<const Volume>, volume);
        QFETCH(Projection, projection);
        QFETCH(double, step);
        QFETCH(double, tolerance);
        const OpacityCurve curve = PowerCurve{2, 0.5};
        const RayCastSettings settings = settingsFor(*volume, Viewpoint{BeamAxis::plusZ, 25, 15, 0}, projection, step);
        compare(volume, curve, settings, tolerance);
    }

    void limitsHoldOnTheCardToo_data() {
        QTest::addColumn<RayCastSettings>("settings");
        for (const Projection projection : {Projection::parallel, Projection::perspective}) {
            const char* name = projection == Projection::parallel ? "parallel" : "perspective";
            const auto volume = smallFetus();
            const RayCastSettings whole = settingsFor(*volume, Viewpoint{BeamAxis::plusZ, 25, 15, 0}, projection, 0.2);
            const Vec3 centre = volume->geometry().centreMm();
            RayCastSettings settings = whole;
            settings.front = CuttingFace{settings.camera.frame.forward, whole.camera.frame.forward.dot(centre) - 4};
            QTest::addRow("near cut %s", name) << settings;
            settings.clippingPlanes = {{centre, {1, 0.5, -0.3}}, {centre + Vec3{0, 20, 0}, {0, -2, 0}}};
            QTest::addRow("near cut and planes %s", name) << settings;
            settings = whole;
            settings.box = RenderBox{{10, 12, -30}, {60, 95, 51}};
            QTest::addRow("box %s", name) << settings;
        }
    }
    void limitsHoldOnTheCardToo() {
        QFETCH(RayCastSettings, settings);
        compare(smallFetus(), PowerCurve{2, 0.5}, settings, 1.5);
    }

    void modesWithoutACurveShowTheSame_data() {
        QTest::addColumn<RenderMode>("mode");
        for (const RenderMode mode : {RenderMode::maximum, RenderMode::minimum, RenderMode::mean}) {
            QTest::newRow(nameOf(mode).data()) << mode;
        }
    }
    void modesWithoutACurveShowTheSame() {
        QFETCH(RenderMode, mode);
        const auto volume = smallFetus();
        RayCastSettings settings =
            settingsFor(*volume, Viewpoint{BeamAxis::plusZ, 25, 15, 0}, Projection::parallel, 0.2);
        settings.mode = mode;
        // Every ray that grazes the box is as bright as one through its middle: along the outline, where one renderer
        // has a sample and the other none, pixels differ by up to white.
        compare(volume, PowerCurve{2, 0.5}, settings, 6.0);
        // Rays without data show nothing, whatever value lies there.
        // The ray caster smooths the border of the data, the card does not.
        compare(maskedToABall(*volume), PowerCurve{2, 0.5}, settings, 13.0);
    }

    void shadingIsTheSame_data() {
        QTest::addColumn<std::shared_ptr<const Volume>>("volume");
        QTest::addColumn<Projection>("projection");
        QTest::addColumn<Vec3>("towardsLight");
        const auto volume = smallFetus();
        QTest::newRow("as it is") << volume << Projection::parallel << Shading{}.towardsLight;
        QTest::newRow("from the right") << volume << Projection::parallel << Vec3{1, 0, -0.2};
        QTest::newRow("perspective") << volume << Projection::perspective << Shading{}.towardsLight;
        QTest::newRow("masked") << maskedToABall(*volume) << Projection::parallel << Shading{}.towardsLight;
        QTest::newRow("anisotropic") << ballInTheCorner({0.5, 1, 2}) << Projection::parallel << Shading{}.towardsLight;
    }
    void shadingIsTheSame() {
        QFETCH(std::shared_ptr<const Volume>, volume);
        QFETCH(Projection, projection);
        QFETCH(Vec3, towardsLight);
        // The ray caster leaves the light of samples out that add little to a pixel: at small steps these are many.
        RayCastSettings settings = settingsFor(*volume, Viewpoint{BeamAxis::plusZ, 25, 15, 0}, projection, 1.0);
        settings.shading = Shading{};
        settings.shading->towardsLight = towardsLight;
        // The faces of cuts are unlit in the ray caster alone.
        compare(volume, PowerCurve{2, 0.5}, settings, 8.0);
    }

    void depthColouringIsTheSame_data() {
        QTest::addColumn<bool>("shaded");
        QTest::addColumn<double>("frontMm");
        QTest::newRow("plain") << false << 0.0;
        QTest::newRow("shaded") << true << 0.0;
        QTest::newRow("near cut") << false << 40.0;
    }
    void depthColouringIsTheSame() {
        QFETCH(bool, shaded);
        QFETCH(double, frontMm);
        const auto volume = smallFetus();
        const Viewpoint view = withFrontAcross({BeamAxis::plusZ, 25, 15, 0}, frontMm);
        RayCastSettings settings = settingsFor(*volume, view, Projection::parallel, shaded ? 1.0 : 0.2);
        settings = limitedTo(view, volume->geometry(), settings);
        settings.depthColouring = DepthColouring{};
        if (shaded) settings.shading = Shading{};
        compare(volume, PowerCurve{2, 0.5}, settings, shaded ? 8.0 : 1.0);
    }

    void anOpaqueActorCutsTheRaysOnTheCard() {
        const auto volume = volumeOf(geometryOf(40, 40, 40), [](double, double, double) { return 200; });
        const OpacityCurve haze = ManualCurve{{{0.0, 0.03}, {1.0, 0.03}}};
        RayCastSettings settings = settingsFor(*volume, {}, Projection::parallel, 0.2);
        DrawnScene card(size, size);
        vtkNew<vtkActor> ball = sphereAt({19.5, 19.5, 25}, 6, {0, 0, 1}, 128);
        card.scene.renderer()->AddActor(ball);
        QVERIFY(!throughTheCard(card, volume, haze, settings).isNull());
        // 19.5 mm of haze before the ball's front at z 19.
        const double transmittance = std::pow(0.97, 19.5);
        const Vec3 expected =
            (colourOf(settings.colourMap, 200 / 255.0) * (1 - transmittance) + Vec3{0, 0, transmittance}) * 255.0;
        const Level seen = card.at(size / 2, size / 2);
        for (std::size_t channel = 0; channel < 3; ++channel) {
            QVERIFY2(
                std::abs(seen[channel] - expected[static_cast<int>(channel)]) < 3,
                qPrintable(QString("%1 instead of %2").arg(seen[channel]).arg(expected[static_cast<int>(channel)])));
        }
    }

    void aZoomedCameraInsideTheVolumeSeesAllOfIt() {
        const auto volume = smallFetus();
        CameraPose pose =
            fittedPose(volume->geometry(), Viewpoint{BeamAxis::plusZ, 25, 15, 0}, Projection::parallel, 1.0);
        pose.heightMm /= 6;  // parallel: VTK's camera stands inside the volume now
        RayCastSettings settings = settingsFor(*volume, pose.view, Projection::parallel, 0.2);
        settings.camera = cameraFor(pose);
        compare(volume, PowerCurve{2, 0.5}, settings, 1.5);
    }

    void thinVolumesAreDrawn_data() {
        QTest::addColumn<std::array<std::int64_t, 3>>("voxels");
        QTest::newRow("1 x 1 x 1") << std::array<std::int64_t, 3>{1, 1, 1};
        QTest::newRow("1 x 30 x 20") << std::array<std::int64_t, 3>{1, 30, 20};
        QTest::newRow("30 x 1 x 20") << std::array<std::int64_t, 3>{30, 1, 20};
    }
    void thinVolumesAreDrawn() {
        using Voxels = std::array<std::int64_t, 3>;
        QFETCH(Voxels, voxels);
        const auto volume =
            volumeOf(geometryOf(voxels[0], voxels[1], voxels[2]), [](double, double, double) { return 180; });
        const RayCastSettings settings =
            settingsFor(*volume, Viewpoint{BeamAxis::plusZ, 30, 20, 0}, Projection::parallel, 0.02);
        compare(volume, ManualCurve{{{0.0, 0.5}, {1.0, 0.5}}}, settings, 2.0);
    }

    void switchingBackAndForthShowsEachRenderersPicture() {
        const auto volume = smallFetus();
        const OpacityCurve curve = PowerCurve{2, 0.5};
        const RayCastSettings settings = settingsFor(*volume, {}, Projection::parallel, 0.5);
        DrawnScene drawn(size, size);
        const QImage card = throughTheCard(drawn, volume, curve, settings);
        drawn.scene.show(std::make_shared<const ScreenPicture>(plainPicture(size, size, {0, 90, 0, 255})),
                         settings.camera);
        drawn.draw();
        QCOMPARE(drawn.at(50, 50), (Level{0, 90, 0}));
        drawn.scene.showLive(settings.camera, settings);
        QCOMPARE(imageOf(drawn), card);
        QVERIFY(drawn.scene.liveMilliseconds() > 0);
        drawn.scene.setVolume(nullptr);
        drawn.draw();
        QCOMPARE(drawn.at(100, 100), (Level{0, 0, 0}));
    }

    void pickersFindTheVolumeOnTheCardToo() {
        const auto volume = ballInTheCorner();
        const RayCastSettings settings = settingsFor(*volume, {}, Projection::parallel, 1.0);
        DrawnScene drawn(size, size);
        QVERIFY(!throughTheCard(drawn, volume, PowerCurve{1, 1.0}, settings).isNull());
        vtkNew<vtkPropPicker> picker;
        const int middle = size / 2;
        picker->PickProp(middle, middle, drawn.scene.renderer());
        QCOMPARE(picker->GetViewProp(), static_cast<vtkProp*>(drawn.scene.volumeProp()));
        QVERIFY(drawn.scene.volumeProp()->GetProperty()->GetScalarOpacity()->GetValue(255) > 0.9);
    }

private:
    /// tolerance: levels of root mean square.
    static void compare(const std::shared_ptr<const Volume>& volume, const OpacityCurve& curve,
                        const RayCastSettings& settings, double tolerance) {
        DrawnScene card(size, size), software(size, size);
        const QImage ours = throughTheRayCaster(software, volume, curve, settings);
        const QImage theirs = throughTheCard(card, volume, curve, settings);
        QVERIFY2(!theirs.isNull(), card.scene.whySoftware().c_str());
        const QString name = QString(QTest::currentTestFunction()) + " " + QTest::currentDataTag();
        keepPictures(name + (volume->dataMask().empty() ? "" : " masked"), ours, theirs);
        const Difference difference = differenceOf(ours, theirs);
        qInfo("%s: %.2f levels of root mean square, %.2f of mean", qPrintable(name), difference.rootMeanSquare,
              difference.mean);
        QVERIFY2(difference.rootMeanSquare < tolerance, qPrintable(QString::number(difference.rootMeanSquare)));
        QImage black(size, size, QImage::Format_RGB888);
        black.fill(Qt::black);
        QVERIFY(differenceOf(black, ours).rootMeanSquare > 10);  // there is something to compare
    }
};

ECHOLUCENT_TEST_CLASS(SceneGraphicsCardTest)
#include "test_scene_graphics_card.moc"
