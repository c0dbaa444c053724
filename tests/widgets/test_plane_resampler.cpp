// Planes outside the GUI thread: what is wanted last is made, and nothing is made twice; and how their greys come
// about.
#include <QTest>
#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/qt_program/test_classes.h"
#include "widgets/planes/grey_image.h"
#include "widgets/planes/plane_resampler.h"

using namespace echolucent;

namespace {

std::shared_ptr<const Volume> someVolume() {
    VolumeGeometry geometry;
    geometry.size = {16, 16, 16};
    std::vector<std::uint8_t> voxels(16 * 16 * 16);
    for (std::size_t i = 0; i < voxels.size(); ++i) voxels[i] = static_cast<std::uint8_t>(i % 251);
    return std::make_shared<const Volume>(geometry, Voxels(std::move(voxels)));
}

/// A picture of all planes at a depth.
std::array<std::optional<PlaneRequest>, 3> requestsAt(const std::shared_ptr<const Volume>& volume, double mm) {
    std::array<std::optional<PlaneRequest>, 3> requests;
    Planes planes;
    planes.offsetMm = {mm, mm, mm};
    for (const PlaneName plane : allPlaneNames)
        requests[indexOf(plane)] =
            PlaneRequest{volume, planeViewOf(planes, plane, BeamAxis::plusZ, volume->dataBox(), 1.0), 24, 24};
    return requests;
}

}  // namespace

class TestPlaneResampler : public QObject {
    Q_OBJECT

    Works m_works;

private slots:
    void whatAHandWantsInARowIsMadeOnceAndTheLastOfItAlways() {
        const auto volume = someVolume();
        PlaneResampler resampler(m_works);
        std::array<std::vector<PlaneRequest>, 3> made;
        connect(&resampler, &PlaneResampler::resampled, this,
                [&](PlaneName plane, const std::shared_ptr<const PlaneSamples>&, const PlaneRequest& request) {
                    made[indexOf(plane)].push_back(request);
                });
        std::array<std::optional<PlaneRequest>, 3> last;
        for (int step = 0; step < 40; ++step) {
            last = requestsAt(volume, 0.1 * step);
            resampler.want(last);
            if (step % 3 == 0) QCoreApplication::processEvents();
        }
        QTRY_VERIFY(m_works.idle());
        for (const PlaneName plane : allPlaneNames) {
            const std::vector<PlaneRequest>& ofPlane = made[indexOf(plane)];
            QVERIFY(!ofPlane.empty());
            QVERIFY(ofPlane.back() == *last[indexOf(plane)]);
            for (std::size_t i = 1; i < ofPlane.size(); ++i)
                QVERIFY2(!(ofPlane[i] == ofPlane[i - 1]), "what was being made already is not made again");
        }
    }

    void aPlaneThatGoesBackEndsAsWhatWasWantedLast() {
        const auto volume = someVolume();
        PlaneResampler resampler(m_works);
        std::array<std::optional<PlaneRequest>, 3> shown;
        connect(&resampler, &PlaneResampler::resampled, this,
                [&](PlaneName plane, const std::shared_ptr<const PlaneSamples>&, const PlaneRequest& request) {
                    shown[indexOf(plane)] = request;
                });
        const auto here = requestsAt(volume, 0.0), there = requestsAt(volume, 3.0);
        auto between = here;
        between[indexOf(PlaneName::b)] = there[indexOf(PlaneName::b)];
        resampler.want(here);
        QTRY_VERIFY(m_works.idle());
        resampler.want(there);    // begins
        resampler.want(between);  // waits
        resampler.want(here);     // waits in its place
        QTRY_VERIFY(m_works.idle());
        QVERIFY(shown == here);
    }

    void greysAreThoseOfWindowLevelAndBrightness() {
        const float none = std::numeric_limits<float>::quiet_NaN();
        PlaneSamples samples;
        samples.columns = 37;  // no multiple of what a processor takes at once
        samples.rows = 3;
        for (int i = 0; i < samples.columns * samples.rows; ++i)
            samples.intensity.push_back(i % 7 == 3 ? none : static_cast<float>(i) / 110.0f);
        const GreyScale scale{.window = 0.5, .level = 0.4, .brightness = 1.2};
        const QImage image = greyImage(samples, scale);
        for (int row = 0; row < samples.rows; ++row)
            for (int column = 0; column < samples.columns; ++column) {
                const float intensity = samples.intensity[static_cast<std::size_t>(row * samples.columns + column)];
                const double grey =
                    255.0 * scale.brightness * (0.5 + (static_cast<double>(intensity) - scale.level) / scale.window);
                const double expected = std::isnan(intensity) ? 0.0 : std::clamp(grey, 0.0, 255.0);
                QVERIFY(std::abs(image.constScanLine(row)[column] - expected) <= 0.51);
            }
        QCOMPARE(int{image.constScanLine(0)[3]}, 0);
        QCOMPARE(int{image.constScanLine(2)[36]}, 255);
    }
};

ECHOLUCENT_TEST_CLASS(TestPlaneResampler)
#include "test_plane_resampler.moc"
