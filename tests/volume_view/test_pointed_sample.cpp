#include <QTest>
#include <cmath>
#include <optional>

#include "processing/picture/camera_pose.h"
#include "processing/picture/view_limits.h"
#include "processing/ray_caster/ray_caster.h"
#include "tests/qt_program/test_classes.h"
#include "tests/volume_view/test_volumes.h"
#include "widgets/volume_view/scene/pointed_sample.h"

using namespace echolucent;
using echolucent::testing::geometryOf;
using echolucent::testing::volumeOf;

namespace {

/// A pane and what it was cast with.
struct ShownPicture {
    PaneRequest pane;
    RayCastSettings settings;
};

std::optional<PointedSample> pointedAt(const ShownPicture& shown, double x, double y) {
    return samplePointedAt(shown.pane, shown.settings, x, y);
}

ShownPicture requestFor(std::shared_ptr<const Volume> volume, const OpacityCurve& curve, const Viewpoint& view = {},
                        Projection projection = Projection::parallel) {
    ShownPicture request{{std::move(volume), curve}, {}};
    request.settings.width = 300;
    request.settings.height = 200;
    request.settings.camera = cameraFor(fittedPose(request.pane.volume->geometry(), view, projection, 1.5));
    request.settings = limitedTo(view, request.pane.volume->geometry(), request.settings);
    return request;
}

/// Slabs across z: 40 before z = 10, 200 from there on; anisotropic.
std::shared_ptr<const Volume> slabs() {
    return volumeOf(geometryOf(20, 20, 20, {1, 1, 2}), [](double, double, double z) { return z < 10 ? 40 : 200; });
}

}  // namespace

class PointedSampleTest : public QObject {
    Q_OBJECT

private slots:
    void firstOpaqueSurfaceIsSeen_data() {
        QTest::addColumn<Projection>("projection");
        QTest::newRow("parallel") << Projection::parallel;
        QTest::newRow("perspective") << Projection::perspective;
    }
    void firstOpaqueSurfaceIsSeen() {
        QFETCH(Projection, projection);
        const OpacityCurve surface = ManualCurve{{{0.5, 0.0}, {0.5, 0.9}}};
        const auto sample = pointedAt(requestFor(slabs(), surface, {}, projection), 150, 100);
        QVERIFY(sample);
        QVERIFY(sample->intensity > 0.5);
        QCOMPARE(sample->opacity, 0.9);
        QVERIFY2(std::abs(sample->gridMm[2] - 19) < 1.1, qPrintable(QString::number(sample->gridMm[2])));
    }

    void fluidIsSeenWhereItIsOpaque() {
        const auto sample = pointedAt(requestFor(slabs(), ManualCurve{{{0.0, 0.95}}}), 150, 100);
        QVERIFY(sample);
        QCOMPARE(sample->intensity, 40 / 255.0);
        QCOMPARE(sample->opacity, 0.95);
    }

    void mostContributingSampleOfAFaintRay() {
        // Two faint peaks: at 100/255 stronger than at 200/255, neither reaching one half.
        const auto volume = volumeOf(geometryOf(9, 9, 30), [](double, double, double z) {
            return z == 8 ? 200 : z == 20 ? 100 : 0;
        });
        const OpacityCurve curve =
            ManualCurve{{{0.3, 0}, {100 / 255.0, 0.30}, {0.5, 0}, {0.7, 0}, {200 / 255.0, 0.1}, {1, 0}}};
        ShownPicture request = requestFor(volume, curve);
        request.settings.interpolation = Interpolation::nearest;
        const auto sample = pointedAt(request, 150, 100);
        QVERIFY(sample);
        QCOMPARE(sample->intensity, 100 / 255.0);
        QVERIFY(std::abs(sample->gridMm[2] - 20) <= 0.5);
    }

    // The picture says at which depth a pixel's opacity reaches one half: that is the sample pointed at, for every
    // step, projection and cut, and so is the brightest one.
    void theRayStepsAsThePictureDoes_data() {
        QTest::addColumn<Projection>("projection");
        QTest::addColumn<double>("step");
        QTest::addColumn<RenderMode>("mode");
        for (const RenderMode mode : {RenderMode::direct, RenderMode::maximum, RenderMode::mean})
            for (const double step : {0.4, 1.0, 2.3}) {
                const QByteArray name = QByteArray::number(step) + QByteArray(nameOf(mode).data());
                QTest::newRow(name + " parallel") << Projection::parallel << step << mode;
                QTest::newRow(name + " perspective") << Projection::perspective << step << mode;
            }
    }
    void theRayStepsAsThePictureDoes() {
        QFETCH(Projection, projection);
        QFETCH(double, step);
        QFETCH(RenderMode, mode);
        const auto volume = volumeOf(geometryOf(24, 21, 26, {1, 1.2, 0.9}),
                                     [](double x, double y, double z) { return 90 + 6 * x - 3 * y + 2 * z; });
        ShownPicture request =
            requestFor(volume, PowerCurve{1, 0.3}, withFrontAcross({BeamAxis::plusZ, 31, -17, 4}, 3.3), projection);
        request.settings.width = 30;
        request.settings.height = 20;
        request.settings.step = step;
        request.settings.mode = mode;
        request.settings.findDepth = true;
        request.settings.terminationTransmittance = 0;
        request.settings.box = RenderBox{{2.1, 1.7, 3.4}, {19, 22, 20}};
        const auto picture = castRays(*volume, request.pane.classification, request.settings);
        int compared = 0, elsewhere = 0;
        for (int row = 0; row < 20; ++row)
            for (int column = 0; column < 30; ++column) {
                const float depth = picture->depthMm[static_cast<std::size_t>(row * 30 + column)];
                if (!std::isfinite(depth)) continue;
                const auto sample = pointedAt(request, column + 0.7, row + 0.2);
                QVERIFY(sample);
                const double pointed = sample->gridMm.dot(request.settings.camera.frame.forward);
                elsewhere += std::abs(pointed - static_cast<double>(depth)) < 2e-3 ? 0 : 1;
                ++compared;
            }
        QVERIFY(compared > 60);
        // A ray whose opacity is one half at a sample, but for the rounding of the kernel's tables, may end at the
        // next.
        QVERIFY2(elsewhere <= compared / 50, qPrintable(QString("%1 of %2").arg(elsewhere).arg(compared)));
    }

    void nearCutHidesWhatLiesBeforeIt() {
        const OpacityCurve opaque = ManualCurve{{{0.0, 1.0}}};
        ShownPicture request = requestFor(slabs(), opaque, withFrontAcross({BeamAxis::plusZ, 0, 0, 0}, 30));
        const auto sample = pointedAt(request, 150, 100);
        QVERIFY(sample);
        QCOMPARE(sample->intensity, 200 / 255.0);
        QVERIFY(sample->gridMm[2] >= 29);
    }

    void limitsHideWhatLiesBeyondThem() {
        const OpacityCurve opaque = ManualCurve{{{0.0, 1.0}}};
        for (const Projection projection : {Projection::parallel, Projection::perspective}) {
            const ShownPicture whole = requestFor(slabs(), opaque, {}, projection);
            ShownPicture request = whole;
            request.settings.box = RenderBox{{-10, -10, 25}, {50, 50, 50}};
            QVERIFY(std::abs(pointedAt(request, 150, 100)->gridMm[2] - 25) < 1.1);
            request.settings.box = RenderBox{{-10, -10, 60}, {50, 50, 90}};
            QVERIFY(!pointedAt(request, 150, 100));
            request = whole;
            request.settings.clippingPlanes = {{{0, 0, 23}, {0, 0, 5}}};
            QVERIFY(std::abs(pointedAt(request, 150, 100)->gridMm[2] - 23) < 1.1);
            request.settings.clippingPlanes.push_back({{0, 0, 22}, {0, 0, -1}});
            QVERIFY(!pointedAt(request, 150, 100));
        }
    }

    void modesWithoutACurvePointAtWhatTheyShow() {
        const auto volume = volumeOf(geometryOf(9, 9, 30), [](double, double, double z) {
            return z == 8 ? 200 : z == 20 ? 10 : 100;
        });
        ShownPicture request = requestFor(volume, ManualCurve{{{0.0, 0.0}, {1.0, 1.0}}});
        request.settings.interpolation = Interpolation::nearest;
        request.settings.mode = RenderMode::maximum;
        QCOMPARE(pointedAt(request, 150, 100)->intensity, 200 / 255.0);
        QCOMPARE(pointedAt(request, 150, 100)->opacity, 200 / 255.0);
        QVERIFY(std::abs(pointedAt(request, 150, 100)->gridMm[2] - 8) <= 0.5);
        request.settings.mode = RenderMode::minimum;
        QCOMPARE(pointedAt(request, 150, 100)->intensity, 10 / 255.0);
        QVERIFY(std::abs(pointedAt(request, 150, 100)->gridMm[2] - 20) <= 0.5);
        request.settings.mode = RenderMode::mean;
        QVERIFY(std::abs(pointedAt(request, 150, 100)->intensity - (28 * 100 + 200 + 10) / 30.0 / 255.0) < 1e-9);
        QVERIFY(!pointedAt(request, 1, 100));
    }

    void thePixelChoosesTheRay() {
        // One bright voxel column; right is +x, down is +y.
        const auto volume =
            volumeOf(geometryOf(21, 11, 5), [](double x, double y, double) { return x == 15 && y == 3 ? 255 : 0; });
        ShownPicture request = requestFor(volume, ManualCurve{{{0.9, 0}, {0.9, 1}}});
        request.settings.interpolation = Interpolation::nearest;
        const double pixelsPerMm = request.settings.height / request.settings.camera.heightMm;
        const double x = 150 + (15 - 10) * pixelsPerMm, y = 100 + (3 - 5) * pixelsPerMm;
        const auto sample = pointedAt(request, x, y);
        QVERIFY(sample);
        QCOMPARE(sample->intensity, 1.0);
        QVERIFY(!pointedAt(request, 300 - x, y));
        QVERIFY(!pointedAt(request, x, 200 - y));
    }

    void modesTellWhatTheyShow() {
        // A ramp along z with one dark and one bright voxel layer; the curve sees nothing of it.
        const auto volume = volumeOf(geometryOf(9, 9, 30), [](double, double, double z) {
            return z == 8 ? 250 : z == 20 ? 5 : 50 + 2 * z;
        });
        ShownPicture request = requestFor(volume, ManualCurve{});
        request.settings.interpolation = Interpolation::nearest;
        QVERIFY(!pointedAt(request, 150, 100));
        const auto pointedIn = [&](RenderMode mode) {
            request.settings.mode = mode;
            return pointedAt(request, 150, 100);
        };
        const auto brightest = pointedIn(RenderMode::maximum), darkest = pointedIn(RenderMode::minimum),
                   mean = pointedIn(RenderMode::mean);
        QVERIFY(brightest && darkest && mean);
        QCOMPARE(brightest->intensity, 250 / 255.0);
        QVERIFY(std::abs(brightest->gridMm[2] - 8) <= 0.5);
        QCOMPARE(darkest->intensity, 5 / 255.0);
        QVERIFY(std::abs(darkest->gridMm[2] - 20) <= 0.5);
        double sum = 250 + 5;
        for (int z = 0; z < 30; ++z) sum += z == 8 || z == 20 ? 0 : 50 + 2 * z;
        QVERIFY(std::abs(mean->intensity - sum / 30 / 255) < 1e-12);
        QVERIFY(mean->gridMm[2] <= 0.5);
        QVERIFY(!pointedAt(request, 1, 100));  // beside the volume
    }

    void nothingWhereNothingIsVisible() {
        QVERIFY(!pointedAt(requestFor(slabs(), ManualCurve{}), 150, 100));
        QVERIFY(!pointedAt(requestFor(slabs(), ManualCurve{{{0.0, 1.0}}}), 1, 100));  // beside the volume
        QVERIFY(!pointedAt({}, 1, 1));
    }

    void noDataIsTransparent() {
        const auto volume = slabs();
        std::vector<std::uint8_t> mask(static_cast<std::size_t>(volume->geometry().voxelCount()), 1);
        std::fill(mask.begin(), mask.begin() + 20 * 20 * 10, std::uint8_t{0});
        const auto masked = std::make_shared<const Volume>(volume->withDataMask(mask));
        const auto sample = pointedAt(requestFor(masked, ManualCurve{{{0.0, 1.0}}}), 150, 100);
        QVERIFY(sample);
        QCOMPARE(sample->intensity, 200 / 255.0);
    }
};

ECHOLUCENT_TEST_CLASS(PointedSampleTest)
#include "test_pointed_sample.moc"
