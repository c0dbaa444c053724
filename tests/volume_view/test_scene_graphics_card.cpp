// What OpenGL draws from the rays, here on Mesa's software, against the processor's picture. Pictures of both and of
// their difference go into the folder that ECHOLUCENT_TEST_PICTURES names, if it is set.
#include <vtkOpenGLRenderWindow.h>
#include <vtkPropPicker.h>
#include <vtkVolume.h>
#include <QDir>
#include <QImage>
#include <QTest>

#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include "processing/card_picture/card_pictures.h"
#include "processing/phantom/phantom.h"
#include "processing/picture/view_limits.h"
#include "processing/ray_caster/ray_caster.h"
#include "tests/qt_program/test_classes.h"
#include "tests/volume_view/drawn_scene.h"
#include "widgets/volume_view/scene/graphics_card/card_renderer.h"

using namespace echolucent;
using namespace echolucent::testing;

namespace {

constexpr int voxelsAcross = 48;  // voxels
constexpr int pixelsAcross = 96;  // pixels

std::shared_ptr<const Volume> smallFetus(int bits = 8) {
    PhantomConfig config = defaultPhantom(PhantomScene::fetus);
    config.size = {voxelsAcross, voxelsAcross - 3, voxelsAcross - 1};  // rows of a texture are not whole words
    config.spacing = {2, 2, 2};
    config.bits = bits;
    return std::make_shared<const Volume>(*makePhantom(config));
}

std::vector<std::uint8_t> maskOf(const VolumeGeometry& geometry, const std::function<bool(const Vec3& voxel)>& isData) {
    std::vector<std::uint8_t> mask;
    for (std::int64_t z = 0; z < geometry.size[2]; ++z)
        for (std::int64_t y = 0; y < geometry.size[1]; ++y)
            for (std::int64_t x = 0; x < geometry.size[0]; ++x)
                mask.push_back(isData({static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)}) ? 1
                                                                                                                : 0);
    return mask;
}

/// Only a ball in the middle is data.
std::shared_ptr<const Volume> inABall(const Volume& volume) {
    return std::make_shared<const Volume>(volume.withDataMask(maskOf(volume.geometry(), [](const Vec3& voxel) {
        return length(voxel - Vec3::all(voxelsAcross / 2)) < 0.4 * voxelsAcross;
    })));
}

std::shared_ptr<const Volume> cutByAScalpel(const Volume& volume) {
    return std::make_shared<const Volume>(
        volume.withCut(std::make_shared<const DataMask>(maskOf(volume.geometry(), [](const Vec3& voxel) {
            return voxel.dot({0.6, 0.5, 0.62}) > 30;
        }))));
}

/// Floats of any magnitude, and some that are none.
std::shared_ptr<const Volume> wildFloats(const Volume& volume) {
    std::vector<float> voxels;
    for (std::int64_t i = 0; i < volume.geometry().voxelCount(); ++i)
        voxels.push_back(static_cast<float>(volume.storedValue(i)) * 1e30f);
    for (const std::size_t hole : {40000u, 50000u, 60001u}) voxels[hole] = std::numeric_limits<float>::quiet_NaN();
    voxels[70000] = 3e38f;
    return std::make_shared<const Volume>(volume.geometry(), VoxelArray<float>(std::move(voxels)), 255e30);
}

RayCastSettings plainSettings(const Volume& volume, Projection projection = Projection::parallel) {
    RayCastSettings settings;
    settings.width = settings.height = pixelsAcross;
    settings.camera = cameraOn(volume, Viewpoint{BeamAxis::plusZ, 25, 15, 0}, projection);
    settings.step = 0.75;
    settings.terminationTransmittance = 1.0 / 128;
    return settings;
}

RayCastSettings litSettings(const Volume& volume, Projection projection = Projection::parallel) {
    RayCastSettings settings = plainSettings(volume, projection);
    settings.shading = Shading{};
    settings.shading->ambient = 0.5;
    settings.shading->diffuse = 1.3;
    settings.shading->reaching = ReachingLight{};
    return settings;
}

CutSurface dome(const Volume& volume, const ViewFrame& frame, double bend = 0.1) {
    const Vec3 centre = volume.geometry().centreMm();
    const double spacing = length(volume.geometry().boxMaxMm()) / 15.0;
    CutSurface surface{.frame = frame, .spacingMm = spacing, .columns = 15, .rows = 15};
    surface.firstRightMm = frame.right.dot(centre) - 7 * spacing;
    surface.firstDownMm = frame.down.dot(centre) - 7 * spacing;
    std::vector<float> depths;
    for (int row = -7; row <= 7; ++row)
        for (int column = -7; column <= 7; ++column)
            depths.push_back(
                static_cast<float>(frame.forward.dot(centre) + spacing * (bend * (row * row + column * column) - 2.0)));
    surface.depthMm = SharedList<float>(std::move(depths));
    return surface;
}

/// A window of VTK's own, and a card that draws in it.
struct CardWindow {
    explicit CardWindow(const CardAnswers& answers = {}) : renderer(answers) {
        window->SetOffScreenRendering(1);
        window->SetMultiSamples(0);
        window->SetSize(16, 16);
        window->Render();
    }
    ~CardWindow() { renderer.release(window); }
    bool draw(const std::shared_ptr<const CardPicture>& picture) {
        window->MakeCurrent();
        return renderer.draw(*vtkOpenGLRenderWindow::SafeDownCast(window), picture, known) ==
               CardRenderer::Drawing::done;
    }
    vtkNew<vtkRenderWindow> window;
    std::shared_ptr<const KnownCardPicture> known = std::make_shared<const KnownCardPicture>(knownCardPicture());
    CardRenderer renderer;
};

std::shared_ptr<const CardPicture> cardPicture(const std::shared_ptr<const Volume>& volume, const Classification& otf,
                                               const RayCastSettings& settings) {
    return std::make_shared<const CardPicture>(CardPictures(volume).make(otf, settings).value());
}

/// Between two pictures, in levels of 8 bits, over pixels that either shows.
struct Difference {
    double rmse = 0;
    int shown = 0;
};
Difference differenceOf(const Picture& a, const Picture& b) {
    Difference found;
    double squares = 0;
    for (std::size_t pixel = 0; pixel < a.rgba.size() / 4; ++pixel) {
        if (!(a.rgba[4 * pixel + 3] > 0) && !(b.rgba[4 * pixel + 3] > 0)) continue;
        ++found.shown;
        for (std::size_t i = 4 * pixel; i < 4 * pixel + 4; ++i)
            squares += std::pow(255.0 * static_cast<double>(a.rgba[i] - b.rgba[i]), 2);
    }
    found.rmse = std::sqrt(squares / std::max(1, 4 * found.shown));
    return found;
}

QImage imageOf(const Picture& picture) {
    const auto rgb = overBackground(picture, {0, 0, 0});
    return QImage(rgb.data(), picture.width, picture.height, 3 * picture.width, QImage::Format_RGB888).copy();
}

/// Side by side: processor, card, and eight times their difference around grey.
void keepPictures(const QString& name, const QImage& processor, const QImage& card) {
    const QString folder = qEnvironmentVariable("ECHOLUCENT_TEST_PICTURES");
    if (folder.isEmpty()) return;
    QImage all(3 * processor.width(), processor.height(), QImage::Format_RGB888);
    for (int y = 0; y < processor.height(); ++y)
        for (int i = 0; i < 3 * processor.width(); ++i) {
            const int a = processor.constScanLine(y)[i], b = card.constScanLine(y)[i];
            all.scanLine(y)[i] = static_cast<uchar>(a);
            all.scanLine(y)[i + 3 * processor.width()] = static_cast<uchar>(b);
            all.scanLine(y)[i + 6 * processor.width()] = static_cast<uchar>(std::clamp(128 + 8 * (b - a), 0, 255));
        }
    QVERIFY(all.save(QDir(folder).filePath(QString(name).replace(' ', '_') + ".png")));
}

const OpacityCurve square = PowerCurve{2, 1.0};

}  // namespace

class SceneGraphicsCardTest : public QObject {
    Q_OBJECT

private slots:
    void theCardDrawsTheProcessorsPicture_data() {
        QTest::addColumn<std::shared_ptr<const Volume>>("volume");
        QTest::addColumn<Classification>("otf");
        QTest::addColumn<RayCastSettings>("settings");
        QTest::addColumn<bool>("eightFetches");
        const auto fetus = smallFetus(), ball = inABall(*fetus);
        const Vec3 centre = fetus->geometry().centreMm();
        const Classification steep = ManualCurve{{{0.25, 0.0}, {0.4, 0.4}, {1.0, 0.9}}};
        const auto add = [](const char* name, const auto& volume, const Classification& otf,
                            const RayCastSettings& settings, bool eightFetches) {
            QTest::newRow(name) << std::shared_ptr<const Volume>(volume) << otf << settings << eightFetches;
        };
        RayCastSettings settings = litSettings(*fetus);
        settings.front = CuttingFace{settings.camera.frame.forward, settings.camera.frame.forward.dot(centre) - 10};
        add("depth light, flat front, filter", fetus, steep, settings, false);
        add("depth light, flat front, eight fetches", fetus, steep, settings, true);
        settings = litSettings(*fetus);
        settings.cutSurface = dome(*fetus, settings.camera.frame);
        settings.depthColouring = DepthColouring{};
        settings.brightness = 1.4;
        add("bowed front, depth colours, words", smallFetus(12), square, settings, false);
        settings = plainSettings(*fetus, Projection::perspective);
        settings.shading = Shading{};
        settings.clippingPlanes = {{centre, {1.0, 0.5, -0.3}}, {centre + Vec3(0, 20, 0), {0.0, -2.0, 0.4}}};
        settings.box = RenderBox{{5, 6, -30}, {85, 95, 80}};
        add("surface light, perspective, planes, box, floats", wildFloats(*fetus), square, settings, true);
        settings = litSettings(*fetus);
        settings.shading->keyHalfAngleDegrees = 0;
        settings.mixing = {0.4, RenderMode::maximum};
        add("mixed, holes", ball, square, settings, false);
        const TwoDimensionalOtf walls =
            tabulated(32, 16, 0.15, [](double f, double g) { return std::clamp(8.0 * g * f, 0.0, 0.8); });
        for (const bool eightFetches : {false, true})
            add(eightFetches ? "two-dimensional OTF, eight fetches" : "two-dimensional OTF, scalpel",
                cutByAScalpel(*fetus), Classification(walls), litSettings(*fetus), eightFetches);
        settings = plainSettings(*fetus);
        settings.interpolation = Interpolation::nearest;
        add("nearest voxel", ball, square, settings, false);
        settings = plainSettings(*fetus);
        settings.mode = RenderMode::maximum;
        add("maximum, holes", ball, square, settings, false);
        settings.mode = RenderMode::minimum;
        add("minimum, holes", ball, square, settings, true);
        settings.mode = RenderMode::mean;
        add("mean, holes", ball, square, settings, false);
        // Rays jump to a ball that lets light through, and leave the front's surface again, which is made for another
        // view.
        const auto ballInNothing = volumeOf(geometryOf(70, 66, 68), [](double x, double y, double z) {
            return length(Vec3(x, y, z) - Vec3(40, 33, 30)) < 18 ? 140 + static_cast<int>(x) : 0;
        });
        settings = litSettings(*ballInNothing);
        settings.cutSurface = dome(*ballInNothing, frameOf(Viewpoint{BeamAxis::plusX, 0, 0, 0}), 0.5);
        settings.lightCoarseness = 8;
        add("bowed front from the side, empty space", ballInNothing, ManualCurve{{{0.4, 0.0}, {0.5, 0.06}, {1.0, 0.1}}},
            settings, true);
        // The extremes.
        settings = plainSettings(*fetus);
        add("opacity 1", fetus, ManualCurve{{{0.0, 1.0}, {1.0, 1.0}}}, settings, true);
        const auto one = volumeOf(geometryOf(1, 1, 1), [](double, double, double) { return 180; });
        add("one voxel", one, ManualCurve{{{0.0, 0.5}, {1.0, 0.5}}}, plainSettings(*one), true);
        const auto slab =
            volumeOf(geometryOf(30, 1, 20), [](double x, double, double) { return 100 + 4 * static_cast<int>(x); });
        add("one voxel thick", slab, ManualCurve{{{0.0, 0.5}, {1.0, 0.5}}}, plainSettings(*slab), true);
        const auto rod = volumeOf(geometryOf(2048, 20, 24), [](double x, double, double z) {
            return 60 + static_cast<int>(x) % 100 + 4 * static_cast<int>(z);
        });
        settings = litSettings(*rod);
        settings.camera.heightMm /= 8;
        add("2,048 voxels along an edge", rod, square, settings, true);
    }
    void theCardDrawsTheProcessorsPicture() {
        QFETCH(std::shared_ptr<const Volume>, volume);
        QFETCH(Classification, otf);
        QFETCH(RayCastSettings, settings);
        QFETCH(bool, eightFetches);
        const Picture processor = *castRays(*volume, otf, settings);
        m_card.renderer.setReading(eightFetches ? CardReading::eightFetches : CardReading::filter);
        QVERIFY2(m_card.draw(cardPicture(volume, otf, settings)), m_card.renderer.failure().c_str());
        const Picture card = m_card.renderer.read();
        keepPictures(QTest::currentDataTag(), imageOf(processor), imageOf(card));
        const Difference found = differenceOf(processor, card);
        qInfo("%s: RMSE %.3f levels, %d pixels", QTest::currentDataTag(), found.rmse, found.shown);
        QVERIFY(found.shown > 300);
        QVERIFY2(found.rmse < (eightFetches ? 0.04 : 0.8), qPrintable(QString::number(found.rmse)));
    }

    void aCurveThatShowsNothingShowsNothing() {
        const auto fetus = smallFetus();
        QVERIFY(m_card.draw(cardPicture(fetus, ManualCurve{{{0.0, 0.0}, {1.0, 0.0}}}, litSettings(*fetus))));
        const Picture card = m_card.renderer.read();
        QVERIFY(std::all_of(card.rgba.begin(), card.rgba.end(), [](float value) { return value == 0.0f; }));
    }

    void bandsMakeTheSamePicture() {
        const auto fetus = smallFetus();
        RayCastSettings settings = plainSettings(*fetus);
        settings.mixing = {0.4, RenderMode::maximum};
        const auto picture = cardPicture(fetus, square, settings);
        m_card.renderer.setReading(CardReading::filter);
        QVERIFY(m_card.draw(picture));
        const Picture whole = m_card.renderer.read();
        m_card.renderer.setReading(CardReading::filter);  // forgets the picture
        m_card.renderer.setSamplesOfBand(1.0);
        QVERIFY(m_card.draw(picture));
        QVERIFY2(m_card.renderer.bands() > 4, qPrintable(QString::number(m_card.renderer.bands())));
        QVERIFY(m_card.renderer.read().rgba == whole.rgba);
    }

    void aPictureInSeveralDrawingsIsTheSame() {
        const auto fetus = smallFetus();
        RayCastSettings settings = plainSettings(*fetus);
        settings.mixing = {0.4, RenderMode::maximum};
        const auto before = cardPicture(fetus, square, litSettings(*fetus)),
                   picture = cardPicture(fetus, square, settings);
        m_card.renderer.setReading(CardReading::filter);
        QVERIFY(m_card.draw(picture));
        const Picture whole = m_card.renderer.read();
        QVERIFY(m_card.draw(before));
        const Picture old = m_card.renderer.read();
        auto& window = *vtkOpenGLRenderWindow::SafeDownCast(m_card.window);
        int drawings = 1;
        m_card.renderer.setSamplesOfBand(1.0);
        for (; m_card.renderer.draw(window, picture, m_card.known, 1e-3) == CardRenderer::Drawing::goesOn; ++drawings) {
            QVERIFY(m_card.renderer.goesOn());
            QCOMPARE(m_card.renderer.drawn(), before);
            if (drawings == 2) QVERIFY(m_card.renderer.read().rgba == old.rgba);  // the picture before stays whole
            QVERIFY(drawings < 1000);
        }
        QVERIFY2(drawings > 4, qPrintable(QString::number(drawings)));
        QVERIFY(!m_card.renderer.goesOn());
        QVERIFY(m_card.renderer.read().rgba == whole.rgba);
        // Another picture takes the place of one that is not done.
        m_card.renderer.setSamplesOfBand(1.0);
        QVERIFY(m_card.renderer.draw(window, before, m_card.known, 1e-3) == CardRenderer::Drawing::goesOn);
        QVERIFY(m_card.draw(picture));
        QVERIFY(!m_card.renderer.goesOn());
        QVERIFY(m_card.renderer.read().rgba == whole.rgba);
    }

    void voxelsAreBroughtToTheCardOnce() {
        const auto first = smallFetus(), second = ballInTheCorner();
        CardPictures one(first), other(second);
        RayCastSettings settings = plainSettings(*first);
        const int before = m_card.renderer.volumesBrought();
        const auto draw = [&](CardPictures& maker) {
            QVERIFY(m_card.draw(std::make_shared<const CardPicture>(maker.make(square, settings).value())));
        };
        draw(one);
        QCOMPARE(m_card.renderer.volumesBrought(), before + 1);
        settings.camera = cameraOn(*first, Viewpoint{BeamAxis::plusZ, 40, 15, 0});
        draw(one);
        one.setCut(cutByAScalpel(*first));
        draw(one);
        QCOMPARE(m_card.renderer.volumesBrought(), before + 1);
        draw(other);
        draw(one);  // as the phases of a heart take turns
        draw(other);
        QCOMPARE(m_card.renderer.volumesBrought(), before + 2);
    }

    void theSceneShowsWhatTheCardDraws() {
        const auto volume = ballInTheCorner();
        RayCastSettings settings = litSettings(*volume);
        const auto ours = castRays(*volume, square, settings);
        DrawnScene drawn(pixelsAcross, pixelsAcross);
        drawn.scene.setRenderer(RendererChoice::graphicsCard);
        drawn.scene.setVolume(volume);
        drawn.scene.setTransfer(square, settings.colourMap);
        drawn.draw();
        auto picture = cardPicture(volume, square, settings);
        const std::weak_ptr<const CardScan> scan = picture->scan;
        drawn.scene.show(std::exchange(picture, nullptr), m_card.known);
        drawn.draw();
        QCOMPARE(drawn.scene.rendererInUse(), RendererChoice::graphicsCard);
        QVERIFY(drawn.scene.cardMilliseconds() > 0);
        const auto expected = overBackground(*ours, {0, 0, 0});
        const auto largestDifference = [&] {
            int largest = 0;
            for (int y = 0; y < pixelsAcross; ++y)
                for (int x = 0; x < pixelsAcross; ++x)
                    for (std::size_t i = 0; i < 3; ++i) {
                        const auto pixel = static_cast<std::size_t>(y * pixelsAcross + x);
                        largest = std::max(largest, std::abs(drawn.at(x, y)[i] - expected[3 * pixel + i]));
                    }
            return largest;
        };
        QVERIFY2(largestDifference() <= 8, qPrintable(QString::number(largestDifference())));
        // A picker finds the volume.
        vtkNew<vtkPropPicker> picker;
        const int middle = pixelsAcross / 2;
        picker->PickProp(middle, middle, drawn.scene.renderer());
        QCOMPARE(picker->GetViewProp(), static_cast<vtkProp*>(drawn.scene.volumeProp()));
        QVERIFY(!scan.expired());
        // Each renderer's picture comes back.
        drawn.scene.show(std::make_shared<const ScreenPicture>(screenPicture(*ours)), settings.camera);
        drawn.draw();
        QVERIFY2(largestDifference() <= 1, qPrintable(QString::number(largestDifference())));
        drawn.scene.show(
            std::make_shared<const ScreenPicture>(plainPicture(pixelsAcross, pixelsAcross, {0, 90, 0, 255})),
            settings.camera);
        drawn.draw();
        QCOMPARE(drawn.at(50, 50), (Level{0, 90, 0}));
        QVERIFY(scan.expired());  // what is on the card keeps nothing in memory
        drawn.scene.setVolume(nullptr);
        drawn.draw();
        QCOMPARE(drawn.at(50, 50), (Level{0, 0, 0}));
    }

private:
    CardWindow m_card;
};

ECHOLUCENT_TEST_CLASS(SceneGraphicsCardTest)
#include "test_scene_graphics_card.moc"
