// The volume through VTK's GPU mapper, here on whatever OpenGL there is, against the software ray caster. Pictures of
// both and of their difference go into the folder that ECHOLUCENT_TEST_PICTURES names, where it is set.
#include <QDir>
#include <QImage>
#include <QTest>
#include <vtkActor.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPropPicker.h>
#include <vtkVolume.h>
#include <vtkVolumeProperty.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "processing/phantom.h"
#include "tests/volume_view/drawn_scene.h"
#include "widgets/volume_view/scene/vtk_volume_image.h"

using namespace echolucent;
using echolucent::testing::ballInTheCorner;
using echolucent::testing::cameraOn;
using echolucent::testing::DrawnScene;
using echolucent::testing::geometryOf;
using echolucent::testing::Level;
using echolucent::testing::plainPicture;
using echolucent::testing::sphereAt;
using echolucent::testing::volumeOf;

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

RayCastSettings settingsFor(const Volume& volume, const View& view, Projection projection, double step) {
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
    drawn.scene.show(std::make_shared<const ScreenPicture>(screenPicture(*picture, settings)), settings.camera);
    return imageOf(drawn);
}

/// What VTK's mapper ought to show of one ray in the modes without a curve, sampled as it samples: a step after the
/// entry, then every step.
double valueAlong(const Volume& volume, const RayCastSettings& settings, int x, int y) {
    const VolumeGeometry& geometry = volume.geometry();
    const Camera& camera = settings.camera;
    const double pixel = camera.heightMm / settings.height;
    const Vec3 origin = camera.focalPoint + camera.frame.right * ((x + 0.5 - settings.width / 2.0) * pixel) +
                        camera.frame.down * ((y + 0.5 - settings.height / 2.0) * pixel);
    double largest = -1, smallest = 2, sum = 0;
    int count = 0;
    for (double along = -200; along < 200; along += settings.step * geometry.unit()) {
        const Vec3 at = origin + camera.frame.forward * along;
        bool inside = true;
        Vec3 voxel = geometry.voxelFromGridMm(at);
        for (int axis = 0; axis < 3; ++axis) {
            const auto last = static_cast<double>(geometry.size[static_cast<std::size_t>(axis)] - 1);
            inside = inside && voxel[axis] >= -0.5 && voxel[axis] <= last + 0.5;
            voxel[axis] = std::clamp(voxel[axis], 0.0, last);
        }
        if (!inside) continue;
        double value = 0;
        for (int corner = 0; corner < 8; ++corner) {
            double weight = 1;
            std::array<std::int64_t, 3> index{};
            for (int axis = 0; axis < 3; ++axis) {
                const auto i = static_cast<std::size_t>(axis);
                const auto low = std::min(static_cast<std::int64_t>(voxel[axis]), geometry.size[i] - 2);
                const double share = voxel[axis] - static_cast<double>(low);
                const bool upper = (corner >> axis & 1) != 0;
                index[i] = low + (upper ? 1 : 0);
                weight *= upper ? share : 1 - share;
            }
            value += weight * volume.normalisedIntensity(geometry.offset(index[0], index[1], index[2]));
        }
        largest = std::max(largest, value);
        smallest = std::min(smallest, value);
        sum += value;
        ++count;
    }
    if (count == 0) return -1;
    if (settings.mode == RenderMode::maximum) return largest;
    return settings.mode == RenderMode::minimum ? smallest : sum / count;
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
        // steps of a unit the samples of the two lie up to a unit apart, which in speckle is another value. At the rim of
        // the data the card knows the nearest voxel only.
        QTest::newRow("8 bit") << bytes << Projection::parallel << 0.2 << 1.0;
        QTest::newRow("12 bit") << smallFetus(12) << Projection::parallel << 0.2 << 1.0;
        QTest::newRow("float") << asFloat(*bytes) << Projection::parallel << 0.2 << 1.0;
        QTest::newRow("perspective") << bytes << Projection::perspective << 0.2 << 1.0;
        QTest::newRow("masked") << maskedToABall(*bytes) << Projection::parallel << 0.2 << 2.0;
        QTest::newRow("step of a unit") << bytes << Projection::parallel << 1.0 << 3.0;
    }
    void bothRenderersShowTheSame() {
        QFETCH(std::shared_ptr<const Volume>, volume);
        QFETCH(Projection, projection);
        QFETCH(double, step);
        QFETCH(double, tolerance);
        const OpacityCurve curve = PowerCurve{2, 0.5};
        const RayCastSettings settings = settingsFor(*volume, View{BeamAxis::plusZ, 25, 15, 0, 0}, projection, step);
        compare(volume, curve, settings, tolerance);
    }

    void nearCutAndBoxAndPlanesHoldOnTheCardToo_data() {
        QTest::addColumn<QString>("limit");
        for (const char* limit : {"near cut", "near cut in perspective", "plane"}) QTest::newRow(limit) << QString(limit);
    }
    void nearCutAndBoxAndPlanesHoldOnTheCardToo() {
        QFETCH(QString, limit);
        const auto volume = smallFetus();
        const auto projection = limit.endsWith("perspective") ? Projection::perspective : Projection::parallel;
        RayCastSettings settings = settingsFor(*volume, View{BeamAxis::plusZ, 25, 15, 0, 0}, projection, 0.2);
        const Vec3& forward = settings.camera.frame.forward;
        const double cut = forward.dot(volume->geometry().centreMm()) - 4;
        RayCastSettings reference = settings;
        reference.nearPlaneDepthMm = cut;
        if (limit.startsWith("near cut")) {
            settings.nearPlaneDepthMm = cut;
        } else {
            settings.clippingPlanes = {{forward * cut, forward * 3.0}};  // the same plane
        }
        compare(volume, PowerCurve{2, 0.5}, settings, 1.5, &reference);
    }

    void theBoxHoldsOnTheCardToo() {
        // What lies outside the box is as if it were not there: here, as if it had no data.
        const auto volume = ballInTheCorner();
        RayCastSettings settings = settingsFor(*volume, View{BeamAxis::plusX, 20, 10, 0, 0}, Projection::parallel, 0.2);
        settings.box = RenderBox{{9.5, 4.5, 3.5}, {29.5, 30.5, 20.5}};
        std::vector<std::uint8_t> mask;
        const VolumeGeometry& geometry = volume->geometry();
        for (std::int64_t z = 0; z < geometry.size[2]; ++z)
            for (std::int64_t y = 0; y < geometry.size[1]; ++y)
                for (std::int64_t x = 0; x < geometry.size[0]; ++x)
                    mask.push_back(x >= 10 && x < 30 && y >= 5 && y < 31 && z >= 4 && z < 21);
        const OpacityCurve curve = PowerCurve{1, 0.2};
        DrawnScene card(size, size), software(size, size);
        const QImage boxed = throughTheCard(card, volume, curve, settings);
        QVERIFY2(!boxed.isNull(), card.scene.whySoftware().c_str());
        settings.box.reset();
        const auto inside = std::make_shared<const Volume>(volume->withDataMask(std::move(mask)));
        const QImage masked = throughTheRayCaster(software, inside, curve, settings);
        keepPictures("box", masked, boxed);
        const Difference difference = differenceOf(masked, boxed);
        // At the box's faces one averages over data only and the other over all: speckle, half a voxel deep.
        qInfo("%.2f levels", difference.rootMeanSquare);
        QVERIFY2(difference.rootMeanSquare < 3.0, qPrintable(QString::number(difference.rootMeanSquare)));
    }

    void modesWithoutACurveShowTheSameValue_data() {
        QTest::addColumn<RenderMode>("mode");
        for (const RenderMode mode : {RenderMode::maximum, RenderMode::minimum, RenderMode::mean}) {
            QTest::newRow(nameOf(mode).data()) << mode;
        }
    }
    void modesWithoutACurveShowTheSameValue() {
        QFETCH(RenderMode, mode);
        const auto volume = smallFetus();
        RayCastSettings settings = settingsFor(*volume, View{BeamAxis::plusZ, 25, 15, 0, 0}, Projection::parallel, 0.2);
        settings.mode = mode;
        DrawnScene card(size, size);
        const QImage seen = throughTheCard(card, volume, PowerCurve{2, 0.5}, settings);
        QVERIFY2(!seen.isNull(), card.scene.whySoftware().c_str());
        double squares = 0;
        int count = 0;
        for (int y = 1; y < size; y += 3) {
            for (int x = 1; x < size; x += 3) {
                const double value = valueAlong(*volume, settings, x, y);
                // Beside the box's outline a ray has only a few samples, or one of the two misses it.
                const bool hit = value >= 0;
                if (hit != (valueAlong(*volume, settings, x - 1, y) >= 0) || hit != (valueAlong(*volume, settings, x + 1, y) >= 0)) continue;
                const Vec3 expected = hit ? colourOf(settings.colourMap, value) * 255.0 : Vec3{0, 0, 0};
                const QRgb pixel = seen.pixel(x, y);
                for (const double off : {qRed(pixel) - expected[0], qGreen(pixel) - expected[1], qBlue(pixel) - expected[2]}) {
                    squares += off * off;
                    ++count;
                }
            }
        }
        const double rootMeanSquare = std::sqrt(squares / count);
        qInfo("%s: %.2f levels", nameOf(mode).data(), rootMeanSquare);
        // The two sample at places up to 0.2 units apart; extremes of speckle change most.
        QVERIFY2(rootMeanSquare < 2.5, qPrintable(QString::number(rootMeanSquare)));
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
        RayCastSettings settings = settingsFor(*volume, View{BeamAxis::plusZ, 25, 15, 0, 0}, projection, 1.0);
        settings.shading = Shading{};
        settings.shading->towardsLight = towardsLight;
        compare(volume, PowerCurve{2, 0.5}, settings, 3.0);
    }

    void depthColouringTintsFromFrontToBack() {
        const auto volume = volumeOf(geometryOf(20, 20, 20), [](double, double, double) { return 255; });
        RayCastSettings settings = settingsFor(*volume, {}, Projection::parallel, 0.2);
        settings.colourMap = ColourMap::grey;
        settings.depthColouring = DepthColouring{{1, 0, 0}, {0, 0, 1}};
        DrawnScene card(size, size);
        const OpacityCurve wall = ManualCurve{{{0.0, 1.0}, {1.0, 1.0}}};
        for (const auto& [cut, red] : {std::pair{-0.5, 255.0}, std::pair{9.5, 255.0}}) {
            // The tints begin at the near plane, so that the cut face has the near tint wherever it lies.
            settings.nearPlaneDepthMm = cut;
            const QImage seen = throughTheCard(card, volume, wall, settings);
            QVERIFY2(!seen.isNull(), card.scene.whySoftware().c_str());
            const QRgb pixel = seen.pixel(size / 2, size / 2);
            QVERIFY2(std::abs(qRed(pixel) - red) <= 8 && qBlue(pixel) <= 8, qPrintable(QString::number(pixel, 16)));
        }
        settings.nearPlaneDepthMm = -0.5;
        settings.clippingPlanes = {{{0, 0, 9.5}, {0, 0, 1}}};  // the middle is seen, the tints still span the box
        const QRgb middle = throughTheCard(card, volume, wall, settings).pixel(size / 2, size / 2);
        QVERIFY2(std::abs(qRed(middle) - 127) <= 6 && std::abs(qBlue(middle) - 127) <= 6,
                 qPrintable(QString::number(middle, 16)));
    }

    void anOpaqueActorCutsTheRaysOnTheCardToo() {
        const auto volume = volumeOf(geometryOf(40, 40, 40), [](double, double, double) { return 200; });
        const OpacityCurve haze = ManualCurve{{{0.0, 0.03}, {1.0, 0.03}}};
        RayCastSettings settings = settingsFor(*volume, {}, Projection::parallel, 0.2);
        DrawnScene card(size, size);
        vtkNew<vtkActor> ball = sphereAt({19.5, 19.5, 25}, 6, {0, 0, 1}, 128);
        card.scene.renderer()->AddActor(ball);
        QVERIFY(!throughTheCard(card, volume, haze, settings).isNull());
        // 19.5 mm of haze before the ball's front at z 19.
        const double transmittance = std::pow(0.97, 19.5);
        const Vec3 expected = (colourOf(settings.colourMap, 200 / 255.0) * (1 - transmittance) + Vec3{0, 0, transmittance}) * 255.0;
        const Level seen = card.at(size / 2, size / 2);
        for (std::size_t channel = 0; channel < 3; ++channel) {
            QVERIFY2(std::abs(seen[channel] - expected[static_cast<int>(channel)]) < 3,
                     qPrintable(QString("%1 instead of %2").arg(seen[channel]).arg(expected[static_cast<int>(channel)])));
        }
    }

    void aZoomedCameraInsideTheVolumeSeesAllOfIt() {
        const auto volume = smallFetus();
        CameraPose pose = fittedPose(volume->geometry(), View{BeamAxis::plusZ, 25, 15, 0, 0}, Projection::parallel, 1.0);
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
        const auto volume = volumeOf(geometryOf(voxels[0], voxels[1], voxels[2]), [](double, double, double) { return 180; });
        const RayCastSettings settings = settingsFor(*volume, View{BeamAxis::plusZ, 30, 20, 0, 0}, Projection::parallel, 0.02);
        compare(volume, ManualCurve{{{0.0, 0.5}, {1.0, 0.5}}}, settings, 2.0);
    }

    void switchingBackAndForthShowsEachRenderersPicture() {
        const auto volume = smallFetus();
        const OpacityCurve curve = PowerCurve{2, 0.5};
        const RayCastSettings settings = settingsFor(*volume, {}, Projection::parallel, 0.5);
        DrawnScene drawn(size, size);
        const QImage card = throughTheCard(drawn, volume, curve, settings);
        drawn.scene.show(std::make_shared<const ScreenPicture>(plainPicture(size, size, {0, 90, 0, 255})), settings.camera);
        drawn.draw();
        QCOMPARE(drawn.at(50, 50), (Level{0, 90, 0}));
        drawn.scene.showLive(settings.camera, settings);
        QCOMPARE(imageOf(drawn), card);
        QVERIFY(drawn.scene.liveMilliseconds() > 0);
        drawn.scene.setVolume(nullptr);
        drawn.draw();
        QCOMPARE(drawn.at(100, 100), (Level{0, 0, 0}));
    }

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
        QTest::newRow("SwiftShader") << "ANGLE (Google, Vulkan 1.3.0 (SwiftShader Device (Subzero)), SwiftShader driver)" << true;
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
        const RayCastSettings settings = settingsFor(*volume, {}, Projection::parallel, 1.0);
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
        RayCastSettings settings = settingsFor(*volume, {}, Projection::parallel, 1.0);
        setTransfer(*property, *volume, PowerCurve{2, 1.0}, ColourMap::sepia);
        card.setLook(settings, *property);
        card.draw(*drawn.scene.renderer(), *vtkOpenGLRenderWindow::SafeDownCast(drawn.window));
        QVERIFY(!card.failure().empty());
        card.setVolume(ballInTheCorner());
        QVERIFY(card.failure().empty());
    }

    void pickersFindTheVolumeOnTheCardToo() {
        const auto volume = ballInTheCorner();
        const RayCastSettings settings = settingsFor(*volume, {}, Projection::parallel, 1.0);
        DrawnScene drawn(size, size);
        QVERIFY(!throughTheCard(drawn, volume, PowerCurve{1, 1.0}, settings).isNull());
        vtkNew<vtkPropPicker> picker;
        picker->PickProp(size / 2, size / 2, drawn.scene.renderer());
        QCOMPARE(picker->GetViewProp(), static_cast<vtkProp*>(drawn.scene.volumeProp()));
        QVERIFY(drawn.scene.volumeProp()->GetProperty()->GetScalarOpacity()->GetValue(255) > 0.9);
    }

private:
    /// Where given, `reference` is what the ray caster is told instead.
    static void compare(const std::shared_ptr<const Volume>& volume, const OpacityCurve& curve,
                        const RayCastSettings& settings, double tolerance, const RayCastSettings* reference = nullptr) {
        DrawnScene card(size, size), software(size, size);
        const QImage ours = throughTheRayCaster(software, volume, curve, reference ? *reference : settings);
        const QImage theirs = throughTheCard(card, volume, curve, settings);
        QVERIFY2(!theirs.isNull(), card.scene.whySoftware().c_str());
        const QString name = QString(QTest::currentTestFunction()) + " " + QTest::currentDataTag();
        keepPictures(name, ours, theirs);
        const Difference difference = differenceOf(ours, theirs);
        qInfo("%s: %.2f levels of root mean square, %.2f of mean", qPrintable(name), difference.rootMeanSquare, difference.mean);
        QVERIFY2(difference.rootMeanSquare < tolerance, qPrintable(QString::number(difference.rootMeanSquare)));
        QImage black(size, size, QImage::Format_RGB888);
        black.fill(Qt::black);
        QVERIFY(differenceOf(black, ours).rootMeanSquare > 10);  // there is something to compare
    }
};

QTEST_APPLESS_MAIN(SceneGraphicsCardTest)
#include "test_scene_graphics_card.moc"
