#include <QTest>
#include <cmath>
#include <numbers>

#include "processing/picture/camera_pose.h"
#include "tests/qt_program/test_classes.h"
#include "tests/volume_view/test_volumes.h"

using namespace echolucent;
using echolucent::testing::geometryOf;

namespace {

/// Where a point appears in the picture: shares of the picture's height from its centre, right and down. Textbook
/// projection, written apart from the program's.
cv::Vec2d projected(const Camera& camera, const Vec3& point) {
    const Vec3 eye = camera.focalPoint - camera.frame.forward * camera.distanceMm;
    const Vec3 seen = point - eye;
    double height = camera.heightMm;
    if (camera.projection == Projection::perspective) {
        const double depth = seen.dot(camera.frame.forward);
        height = 2 * depth * std::tan(camera.viewAngleDegrees * std::numbers::pi / 360);
    }
    return {seen.dot(camera.frame.right) / height, seen.dot(camera.frame.down) / height};
}

CameraPose poseOf(const Viewpoint& view, Projection projection = Projection::parallel) {
    return fittedPose(geometryOf(40, 30, 20, {1, 1, 2}), view, projection, 1.5);
}

void compareVectors(const Vec3& a, const Vec3& b, double tolerance = 1e-9) {
    QVERIFY2(
        length(a - b) <= tolerance,
        qPrintable(
            QString("(%1, %2, %3) against (%4, %5, %6)").arg(a[0]).arg(a[1]).arg(a[2]).arg(b[0]).arg(b[1]).arg(b[2])));
}

const Viewpoint tilted = withFrontAcross({BeamAxis::plusY, 30, -20, 50}, 4);

}  // namespace

Q_DECLARE_METATYPE(echolucent::Viewpoint)

class CameraPoseTest : public QObject {
    Q_OBJECT

private slots:
    void whatIsInFrontFollowsTheHand_data() {
        QTest::addColumn<int>("beamAxis");
        QTest::addColumn<double>("roll");
        QTest::addColumn<double>("right");
        QTest::addColumn<double>("down");
        for (const int axis : {0, 1, 2, 3, 4, 5}) {
            for (const double roll : {0.0, 90.0, -35.0}) {
                QTest::addRow("%s roll %g right", nameOf(BeamAxis(axis)).data(), roll) << axis << roll << 1e-4 << 0.0;
                QTest::addRow("%s roll %g down", nameOf(BeamAxis(axis)).data(), roll) << axis << roll << 0.0 << 1e-4;
            }
        }
    }
    void whatIsInFrontFollowsTheHand() {
        QFETCH(int, beamAxis);
        QFETCH(double, roll);
        QFETCH(double, right);
        QFETCH(double, down);
        CameraPose pose = poseOf({BeamAxis(beamAxis), 0, 0, roll});
        const Camera before = cameraFor(pose);
        const Vec3 inFront = pose.focalPoint - before.frame.forward * 5.0;
        const cv::Vec2d moved = projected(cameraFor(orbited(pose, right, down)), inFront) - projected(before, inFront);
        // In the direction of the drag, and only in it (but for the order in which the two angles turn).
        const double along = moved[0] * right + moved[1] * down;
        QVERIFY(along > 0);
        QVERIFY(std::abs(moved[0] * down - moved[1] * right) < 1e-3 * along);
        // The point it turns about stays.
        const cv::Vec2d pivot = projected(cameraFor(orbited(pose, right, down)), pose.focalPoint);
        QVERIFY(cv::norm(pivot) < 1e-12);
    }

    void heightOfThePictureIsHalfATurn() {
        const CameraPose pose = poseOf({});
        compareVectors(frameOf(orbited(pose, 1.0, 0).view).forward, -frameOf(pose.view).forward);
        compareVectors(frameOf(orbited(pose, 0, -0.25).view).forward, frameOf({BeamAxis::plusZ, 0, 45, 0}).forward);
    }

    /// Twenty directions of looking, both poles among them.
    void dragsTurnByTheirAngleAboutTheScreensAxes_data() {
        QTest::addColumn<Viewpoint>("from");
        constexpr double angles[][3] = {{0, 0, 0},       {90, 0, 0},       {-135, 0, 0},    {180, 0, 0},
                                        {0, 90, 0},      {0, -90, 0},      {40, 90, 0},     {-70, -90, 25},
                                        {120, 90, -160}, {0, 45, 0},       {30, -20, 50},   {-60, 60, 90},
                                        {75, -89.99, 3}, {10, 89.9999, 0}, {0, 0, 90},      {0, 0, -37},
                                        {150, 10, 180},  {-20, -70, -90},  {5, 1e-9, 1e-9}, {-179, 33, 12}};
        for (int i = 0; i < 20; ++i)
            QTest::addRow("%d: azimuth %g, elevation %g, roll %g", i, angles[i][0], angles[i][1], angles[i][2])
                << Viewpoint{BeamAxis(i % 6), angles[i][0], angles[i][1], angles[i][2]};
    }
    void dragsTurnByTheirAngleAboutTheScreensAxes() {
        QFETCH(Viewpoint, from);
        CameraPose pose = poseOf(from);
        pose.focalPoint += Vec3(3, -7, 5);
        const ViewFrame before = frameOf(from);
        for (const double degrees : {1.0, -30.0, 90.0, 135.0, -179.0}) {
            const double share = degrees / degreesPerHeight;
            const double c = std::cos(degrees * std::numbers::pi / 180), s = std::sin(degrees * std::numbers::pi / 180);
            // Sideways: what is in front follows the hand, so the eye goes the other way round the vertical.
            const CameraPose sideways = orbited(pose, share, 0);
            compareVectors(frameOf(sideways.view).down, before.down, 1e-12);
            compareVectors(frameOf(sideways.view).forward, before.forward * c + before.right * s, 1e-12);
            compareVectors(frameOf(sideways.view).right, before.right * c - before.forward * s, 1e-12);
            // Down: the same about the horizontal.
            const CameraPose down = orbited(pose, 0, share);
            compareVectors(frameOf(down.view).right, before.right, 1e-12);
            compareVectors(frameOf(down.view).forward, before.forward * c + before.down * s, 1e-12);
            compareVectors(frameOf(down.view).down, before.down * c - before.forward * s, 1e-12);
            // Aslant: about the axis across the drag, here in the direction (3, 4) of the picture.
            const ViewFrame aslant = frameOf(orbited(pose, 0.6 * share, 0.8 * share).view);
            const Vec3 along = before.right * 0.6 + before.down * 0.8, across = before.down * 0.6 - before.right * 0.8;
            compareVectors(aslant.forward, before.forward * c + along * s, 1e-12);
            compareVectors(aslant.down * 0.6 - aslant.right * 0.8, across, 1e-12);
            for (const CameraPose& turned : {sideways, down}) {
                QVERIFY(std::abs(turned.view.elevationDegrees) <= 90.0);
                QVERIFY(turned.focalPoint == pose.focalPoint);  // it turns about the point at the picture's centre
                QCOMPARE(turned.heightMm, pose.heightMm);
            }
        }
    }

    void manySmallDragsTurnAsFarAsOne() {
        for (const cv::Vec2d& way : {cv::Vec2d(0.01, 0), cv::Vec2d(0, 0.01), cv::Vec2d(-0.006, 0.008)}) {
            CameraPose pose = poseOf(tilted);
            for (int i = 0; i < 200; ++i) pose = orbited(pose, way[0], way[1]);  // a whole turn, over both poles
            compareVectors(frameOf(pose.view).forward, frameOf(tilted).forward, 1e-11);
            compareVectors(frameOf(pose.view).down, frameOf(tilted).down, 1e-11);
        }
    }

    void aDragAlongAnAxisOfTheBeamChangesNoOtherAngle() {
        CameraPose pose = poseOf({});
        for (int i = 0; i < 7; ++i) pose = orbited(pose, 0.013, 0);
        QVERIFY(pose.view.elevationDegrees == 0.0 && pose.view.rollDegrees == 0.0);
        for (int i = 0; i < 7; ++i) pose = orbited(pose, 0, 0.013);
        QVERIFY(std::abs(pose.view.azimuthDegrees - 7 * 0.013 * 180) < 1e-12 && pose.view.rollDegrees == 0.0);
    }

    void azimuthStaysWithinHalfATurn() {
        CameraPose pose = poseOf({});
        for (int i = 0; i < 50; ++i) {
            pose = orbited(pose, 0.11, 0);
            QVERIFY(pose.view.azimuthDegrees > -180.0 && pose.view.azimuthDegrees <= 180.0);
        }
        QVERIFY(std::abs(std::remainder(pose.view.azimuthDegrees - 50 * 0.11 * 180, 360.0)) < 1e-9);
    }

    void panFollowsTheHandExactly_data() {
        QTest::addColumn<Projection>("projection");
        QTest::newRow("parallel") << Projection::parallel;
        QTest::newRow("perspective") << Projection::perspective;
    }
    void panFollowsTheHandExactly() {
        QFETCH(Projection, projection);
        const CameraPose pose = poseOf(tilted, projection);
        const cv::Vec2d moved = projected(cameraFor(panned(pose, 0.2, -0.1)), pose.focalPoint);
        QVERIFY(std::abs(moved[0] - 0.2) < 1e-12);
        QVERIFY(std::abs(moved[1] + 0.1) < 1e-12);
    }

    void zoomMagnifiesTheFocalPlane_data() { panFollowsTheHandExactly_data(); }
    void zoomMagnifiesTheFocalPlane() {
        QFETCH(Projection, projection);
        const CameraPose pose = poseOf(tilted, projection);
        const Vec3 point = pose.focalPoint + frameOf(tilted).right * 3.0 + frameOf(tilted).down;
        const cv::Vec2d before = projected(cameraFor(pose), point);
        const cv::Vec2d after = projected(cameraFor(zoomed(pose, 2.0, zoomLimits(geometryOf(40, 30, 20)))), point);
        QVERIFY(cv::norm(after - before * 2.0) < 1e-12);
    }

    void zoomKeepsWithinItsLimits() {
        const VolumeGeometry geometry = geometryOf(40, 30, 20, {1, 1, 2});
        CameraPose pose = poseOf({});
        for (int i = 0; i < 100; ++i) pose = zoomed(pose, 1.5, zoomLimits(geometry));
        QCOMPARE(pose.heightMm, 2.0);
        for (int i = 0; i < 200; ++i) pose = zoomed(pose, 0.5, zoomLimits(geometry));
        QCOMPARE(pose.heightMm, 10.0 * std::hypot(40, 30, 40));
    }

    void fittedPoseShowsTheWholeVolume_data() { panFollowsTheHandExactly_data(); }
    void fittedPoseShowsTheWholeVolume() {
        QFETCH(Projection, projection);
        const VolumeGeometry geometry = geometryOf(40, 30, 20, {1, 1, 2});
        for (const Viewpoint& view : {Viewpoint{}, tilted, Viewpoint{BeamAxis::plusX, 45, 45, 0}}) {
            for (const double aspect : {0.5, 1.0, 2.5}) {
                const Camera camera = cameraFor(fittedPose(geometry, view, projection, aspect));
                double furthest = 0;
                for (int corner = 0; corner < 8; ++corner) {
                    const Vec3 low = geometry.boxMinMm(), high = geometry.boxMaxMm();
                    const cv::Vec2d at = projected(
                        camera,
                        {corner & 1 ? high[0] : low[0], corner & 2 ? high[1] : low[1], corner & 4 ? high[2] : low[2]});
                    furthest = std::max({furthest, std::abs(at[0]) / aspect, std::abs(at[1])});
                }
                QVERIFY2(furthest <= 0.5, qPrintable(QString::number(furthest)));
                QVERIFY2(furthest > 0.3, qPrintable(QString::number(furthest)));
            }
        }
    }
};

ECHOLUCENT_TEST_CLASS(CameraPoseTest)
#include "test_camera_pose.moc"
