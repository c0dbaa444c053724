// VTK's own opaque actors inside, before and behind the volume: what is seen, and what finding their depths costs.
#include <vtkActor.h>
#include <vtkTextActor.h>
#include <QDir>
#include <QImage>
#include <QTest>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "processing/ray_caster.h"
#include "tests/qt_program/test_classes.h"
#include "tests/volume_view/drawn_scene.h"

using namespace echolucent;
using namespace echolucent::testing;

namespace {

constexpr int pixels = 120;
constexpr double infinite = std::numeric_limits<double>::infinity();

/// The ray through the centre of a pixel.
struct Ray {
    Vec3 origin, direction;  // unit; perspective: the origin is the eye
};

Ray rayThrough(const Camera& camera, int x, int y, int size) {
    const bool parallel = camera.projection == Projection::parallel;
    const double height =
        parallel ? camera.heightMm : 2 * camera.distanceMm * std::tan(camera.viewAngleDegrees * std::numbers::pi / 360);
    const Vec3 inPlane = camera.frame.right * ((x + 0.5 - size / 2.0) * height / size) +
                         camera.frame.down * ((y + 0.5 - size / 2.0) * height / size);
    if (parallel) return {camera.focalPoint + inPlane - camera.frame.forward * 1000, camera.frame.forward};
    return {camera.focalPoint - camera.frame.forward * camera.distanceMm,
            normalized(camera.frame.forward * camera.distanceMm + inPlane)};
}

struct Segment {
    double from = 0, to = 0;
};

Segment throughBox(const Ray& ray, const VolumeGeometry& geometry) {
    Segment inside{0, infinite};
    for (int axis = 0; axis < 3; ++axis) {
        const double one = (geometry.boxMinMm()[axis] - ray.origin[axis]) / ray.direction[axis];
        const double other = (geometry.boxMaxMm()[axis] - ray.origin[axis]) / ray.direction[axis];
        if (ray.direction[axis] == 0) {
            if (ray.origin[axis] < geometry.boxMinMm()[axis] || ray.origin[axis] > geometry.boxMaxMm()[axis]) return {};
            continue;
        }
        inside.from = std::max(inside.from, std::min(one, other));
        inside.to = std::min(inside.to, std::max(one, other));
    }
    return inside.to > inside.from ? inside : Segment{};
}

/// A volume of one opacity everywhere, with a ball half inside it, half outside.
struct HalfInside {
    static constexpr double opacity = 0.03;  // per unit
    static constexpr int intensity = 200;
    std::shared_ptr<const Volume> volume =
        volumeOf(geometryOf(40, 36, 32), [](double, double, double) { return intensity; });
    OpacityCurve curve = ManualCurve{{{0.0, opacity}, {1.0, opacity}}};
    Vec3 centre{39.5, 16, 13};  // on the face of large x
    double radius = 10;
    Vec3 ballColour{0, 0.2, 1};

    double ballAt(const Ray& ray) const {
        const Vec3 to = centre - ray.origin;
        const double along = to.dot(ray.direction), off = std::sqrt(std::max(0.0, to.dot(to) - along * along));
        return off < radius ? along - std::sqrt(radius * radius - off * off) : infinite;
    }
    /// Levels by eq. 3 in closed form: the volume up to the ball, then the ball, or black.
    Vec3 seen(const Ray& ray) const {
        const Segment box = throughBox(ray, volume->geometry());
        const double ball = ballAt(ray);
        const double transmittance = std::pow(1 - opacity, std::max(0.0, std::min(box.to, ball) - box.from));
        const Vec3 behind = ball < infinite ? ballColour : Vec3{0, 0, 0};
        return (colourOf(ColourMap::sepia, intensity / 255.0) * (1 - transmittance) + behind * transmittance) * 255.0;
    }
    /// True where the pixel is near the ball's or the box's outline, in which a facet or a pixel's corner decides.
    bool onOutline(const Camera& camera, int x, int y) const {
        const double reach = 1.0;
        bool inBall = false, outOfBall = false, inBox = false, outOfBox = false;
        for (const double dx : {-reach, 0.0, reach}) {
            for (const double dy : {-reach, 0.0, reach}) {
                const Ray ray = rayThrough(camera, x + static_cast<int>(dx), y + static_cast<int>(dy), pixels);
                const Segment box = throughBox(ray, volume->geometry());
                (ballAt(ray) < infinite ? inBall : outOfBall) = true;
                (box.to > box.from ? inBox : outOfBox) = true;
            }
        }
        return (inBall && outOfBall) || (inBox && outOfBox);
    }
};

/// Into the folder that ECHOLUCENT_TEST_PICTURES names, where it is set.
void keepPicture(DrawnScene& drawn) {
    const QString folder = qEnvironmentVariable("ECHOLUCENT_TEST_PICTURES");
    if (folder.isEmpty()) return;
    const QString name = QString(QTest::currentTestFunction()) + " " + QTest::currentDataTag();
    const QImage fromBelow(drawn.pixels->GetPointer(0), drawn.width(), drawn.height(), 3 * drawn.width(),
                           QImage::Format_RGB888);
    QVERIFY(fromBelow.mirrored().save(QDir(folder).filePath(QString(name).replace(' ', '_') + ".png")));
}

}  // namespace

class SceneActorsTest : public QObject {
    Q_OBJECT

private slots:
    void aBallHalfInsideIsRightFromAllSides_data() {
        QTest::addColumn<Viewpoint>("view");
        QTest::addColumn<Projection>("projection");
        const std::array<std::pair<const char*, BeamAxis>, 6> sides{{{"+x", BeamAxis::plusX},
                                                                     {"-x", BeamAxis::minusX},
                                                                     {"+y", BeamAxis::plusY},
                                                                     {"-y", BeamAxis::minusY},
                                                                     {"+z", BeamAxis::plusZ},
                                                                     {"-z", BeamAxis::minusZ}}};
        for (const auto& [name, axis] : sides)
            QTest::newRow(name) << Viewpoint{axis, 0, 0, 0, 0} << Projection::parallel;
        QTest::newRow("turned") << Viewpoint{BeamAxis::plusY, 35, -20, 30, 0} << Projection::parallel;
        QTest::newRow("perspective") << Viewpoint{BeamAxis::minusX, 30, 25, 0, 0} << Projection::perspective;
    }
    void aBallHalfInsideIsRightFromAllSides() {
        QFETCH(Viewpoint, view);
        QFETCH(Projection, projection);
        const HalfInside half;
        DrawnScene drawn(pixels, pixels);
        drawn.scene.setVolume(half.volume);
        vtkNew<vtkActor> ball =
            sphereAt(half.centre, half.radius, {half.ballColour[0], half.ballColour[1], half.ballColour[2]}, 256);
        drawn.scene.renderer()->AddActor(ball);
        drawn.draw();

        RayCastSettings settings;
        settings.width = settings.height = pixels;
        settings.camera = cameraOn(*half.volume, view, projection);
        settings.camera.heightMm *= 1.5;  // the whole ball too
        settings.camera.distanceMm *= 1.5;
        settings.step = 0.1;
        settings.terminationTransmittance = 1e-6;
        settings.opaqueDepth = drawn.scene.opaqueDepth(settings.camera, pixels, pixels);
        QVERIFY(settings.opaqueDepth);
        const auto picture = castRays(*half.volume, half.curve, settings);
        QVERIFY(picture);
        drawn.scene.show(std::make_shared<const ScreenPicture>(screenPicture(*picture, settings)), settings.camera);
        drawn.draw();

        keepPicture(drawn);
        // 8 bits twice, facets, and half a step of 0.1 units at each end of a ray: each below a level.
        constexpr double tolerance = 3.0;
        int compared = 0, onBall = 0;
        for (int y = 0; y < pixels; ++y) {
            for (int x = 0; x < pixels; ++x) {
                if (half.onOutline(settings.camera, x, y)) continue;
                const Ray ray = rayThrough(settings.camera, x, y, pixels);
                const Vec3 expected = half.seen(ray);
                const Level seen = drawn.at(x, y);
                ++compared;
                onBall += half.ballAt(ray) < infinite;
                for (int channel = 0; channel < 3; ++channel) {
                    QVERIFY2(std::abs(seen[static_cast<std::size_t>(channel)] - expected[channel]) <= tolerance,
                             qPrintable(QString("pixel %1, %2 channel %3: %4 instead of %5")
                                            .arg(x)
                                            .arg(y)
                                            .arg(channel)
                                            .arg(seen[static_cast<std::size_t>(channel)])
                                            .arg(expected[channel])));
                }
            }
        }
        QVERIFY(compared > pixels * pixels * 3 / 4);
        QVERIFY(onBall > 200);
    }

    void depthsOfActorsAreInMillimetresAlongTheView_data() { projections(); }
    void depthsOfActorsAreInMillimetresAlongTheView() {
        QFETCH(Viewpoint, view);
        QFETCH(Projection, projection);
        const HalfInside half;
        DrawnScene drawn(40, 30);  // another size and shape than the map
        drawn.scene.setVolume(half.volume);
        vtkNew<vtkActor> ball = sphereAt(half.centre, half.radius, {1, 1, 1}, 256);
        drawn.scene.renderer()->AddActor(ball);
        drawn.draw();
        const Camera camera = cameraOn(*half.volume, view, projection);
        const auto map = drawn.scene.opaqueDepth(camera, pixels, pixels);
        QVERIFY(map && map->width == pixels && map->height == pixels);
        QCOMPARE(map->depthMm.size(), static_cast<std::size_t>(pixels) * pixels);
        int onBall = 0;
        for (int y = 0; y < pixels; ++y) {
            for (int x = 0; x < pixels; ++x) {
                if (half.onOutline(camera, x, y)) continue;
                const Ray ray = rayThrough(camera, x, y, pixels);
                const double along = half.ballAt(ray);
                const double found = map->depthMm[static_cast<std::size_t>(y * pixels + x)];
                if (along == infinite) {
                    QCOMPARE(found, infinite);
                    continue;
                }
                ++onBall;
                const double expected = camera.frame.forward.dot(ray.origin + ray.direction * along);
                // A facet lies up to 0.0008 mm below the ball, seen aslant up to a few times that.
                QVERIFY2(std::abs(found - expected) < 0.01,
                         qPrintable(QString("%1 instead of %2").arg(found).arg(expected)));
            }
        }
        QVERIFY(onBall > 400);
    }

    void anActorBehindAZoomedParallelCameraIsNotCut() {
        // VTK puts a camera at its distance before the focal point, rays come from as far as the volume reaches.
        const auto volume = ballInTheCorner();
        DrawnScene drawn(60, 60);
        drawn.scene.setVolume(volume);
        vtkNew<vtkActor> ball = sphereAt(volume->geometry().centreMm() - Vec3{0, 0, 20}, 5, {0, 1, 0});
        drawn.scene.renderer()->AddActor(ball);
        drawn.draw();
        CameraPose pose = fittedPose(volume->geometry(), {}, Projection::parallel, 1.0);
        pose.heightMm = 4;
        const Camera camera = cameraFor(pose);
        QVERIFY(camera.distanceMm < 15);
        const auto map = drawn.scene.opaqueDepth(camera, 60, 60);
        QVERIFY(std::isfinite(map->depthMm[30 * 60 + 30]));
        drawn.scene.show(std::make_shared<const ScreenPicture>(plainPicture(60, 60, {0, 0, 0, 0})), camera);
        drawn.draw();
        QCOMPARE(drawn.at(30, 30), (Level{0, 255, 0}));
    }

    void noDepthIsReadWithoutOpaqueActors() {
        const auto volume = ballInTheCorner();
        DrawnScene drawn(50, 50);
        drawn.scene.setVolume(volume);
        drawn.scene.setAnnotationsVisible(true);
        const Camera camera = cameraOn(*volume, {});
        vtkNew<vtkTextActor> words;
        words->SetInput("over the picture");
        drawn.scene.renderer()->AddActor2D(words);
        vtkNew<vtkActor> hidden = sphereAt({5, 5, 5}, 3, {1, 1, 1});
        hidden->SetVisibility(false);
        drawn.scene.renderer()->AddActor(hidden);
        drawn.scene.show(std::make_shared<const ScreenPicture>(plainPicture(50, 50, {9, 9, 9, 9})), camera);
        drawn.draw();
        QVERIFY(!drawn.scene.hasOpaqueProps());
        QVERIFY(!drawn.scene.wantsDepth());
        QVERIFY(!drawn.scene.opaqueDepth(camera, 50, 50));

        drawn.scene.setDepthWanted(true);
        QVERIFY(drawn.scene.wantsDepth());
    }

    void depthIsReadOnceForTheSameScene() {
        const auto volume = ballInTheCorner();
        DrawnScene drawn(50, 50);
        drawn.scene.setVolume(volume);
        vtkNew<vtkActor> ball = sphereAt({5, 5, 5}, 4, {1, 1, 1});
        drawn.scene.renderer()->AddActor(ball);
        drawn.draw();
        Camera camera = cameraOn(*volume, {});
        const auto first = drawn.scene.opaqueDepth(camera, 50, 50);
        QVERIFY(first);
        drawn.scene.show(std::make_shared<const ScreenPicture>(plainPicture(50, 50, {9, 9, 9, 9})), camera);
        drawn.draw();
        QCOMPARE(drawn.scene.opaqueDepth(camera, 50, 50), first);

        ball->GetProperty()->SetColor(1, 0, 0);  // changes the actor, not where it stands
        QCOMPARE(drawn.scene.opaqueDepth(camera, 50, 50), first);
        ball->SetPosition(3, 0, 0);
        const auto moved = drawn.scene.opaqueDepth(camera, 50, 50);
        QVERIFY(moved != first && moved->depthMm != first->depthMm);
        camera.heightMm *= 2;
        QVERIFY(drawn.scene.opaqueDepth(camera, 50, 50) != moved);
        QCOMPARE(drawn.scene.opaqueDepth(camera, 25, 20)->width, 25);
        ball->SetVisibility(false);
        QVERIFY(!drawn.scene.opaqueDepth(camera, 25, 20));
    }

    void readingDepthLeavesThePictureAlone() {
        const auto volume = ballInTheCorner();
        DrawnScene drawn(50, 50);
        drawn.scene.setVolume(volume);
        vtkNew<vtkActor> ball = sphereAt({5, 5, -8}, 4, {0, 1, 0});
        drawn.scene.renderer()->AddActor(ball);
        const Camera camera = cameraOn(*volume, {});
        drawn.scene.show(std::make_shared<const ScreenPicture>(plainPicture(50, 50, {70, 0, 0, 128})), camera);
        drawn.draw();
        const std::vector<unsigned char> before(drawn.pixels->GetPointer(0), drawn.pixels->GetPointer(3 * 50 * 50));
        Camera other = cameraOn(*volume, Viewpoint{BeamAxis::minusY, 20, 10, 5, 0}, Projection::perspective);
        QVERIFY(drawn.scene.opaqueDepth(other, 33, 21));
        QCOMPARE(drawn.scene.camera().projection, Projection::parallel);
        drawn.draw();
        const std::vector<unsigned char> after(drawn.pixels->GetPointer(0), drawn.pixels->GetPointer(3 * 50 * 50));
        QVERIFY(before == after);
    }

private:
    static void projections() {
        QTest::addColumn<Viewpoint>("view");
        QTest::addColumn<Projection>("projection");
        QTest::newRow("parallel +z") << Viewpoint{} << Projection::parallel;
        QTest::newRow("parallel turned") << Viewpoint{BeamAxis::minusY, 35, -20, 15, 0} << Projection::parallel;
        QTest::newRow("perspective +x") << Viewpoint{BeamAxis::plusX, 0, 0, 0, 0} << Projection::perspective;
        QTest::newRow("perspective turned") << Viewpoint{BeamAxis::minusX, 30, 40, 15, 0} << Projection::perspective;
    }
};

ECHOLUCENT_TEST_CLASS(SceneActorsTest)
#include "test_scene_actors.moc"
