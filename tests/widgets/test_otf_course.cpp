// The OTFs of a motion: every mode against its own history, jumps, rows, flicker, and what is drawn of it.
#include <QColor>
#include <QImage>
#include <QLabel>
#include <QLocale>
#include <QObject>
#include <QPoint>
#include <QRgb>
#include <QTest>
#include <QWidget>

#include "processing/motion/flicker.h"
#include "tests/qt_program/test_classes.h"
#include "tests/widgets/panel_controls.h"
#include "widgets/motion/otf_course_panel.h"
#include "widgets/motion/otf_curves_canvas.h"
#include "widgets/motion/otf_map_canvas.h"

using namespace echolucent;

namespace {

/// A curve that wavers from frame to frame.
SampledCurve curveOfFrame(int frame) {
    SampledCurve curve{std::vector<double>(256)};
    for (int i = 0; i < 256; ++i) {
        const double x = i / 255.0;
        curve.opacities[static_cast<std::size_t>(i)] =
            std::clamp(x * (0.6 + 0.3 * std::sin(2.1 * frame + 3.0 * x)), 0.0, 1.0);
    }
    return curve;
}

constexpr std::array<std::pair<MotionOtf, OtfSmoothing>, 4> smoothed{
    {{MotionOtf::eachView, OtfSmoothing::none},
     {MotionOtf::mean, OtfSmoothing::mean},
     {MotionOtf::movingLeastSquares, OtfSmoothing::movingLeastSquares},
     {MotionOtf::leastFlicker, OtfSmoothing::leastFlicker}}};

}  // namespace

class TestOtfCourse : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void everyModeIsItsHistory() {
        OtfCourse course;
        for (const auto& [mode, smoothing] : smoothed) {
            course.begin(OtfCourse::Rows::angles);
            OtfHistory history(smoothing);
            std::vector<SampledCurve> shown;
            for (int frame = 0; frame < 20; ++frame) {
                course.add({.angle = frame - 10}, curveOfFrame(frame));
                shown.push_back(history.add(frame, curveOfFrame(frame)));
                QVERIFY(course.newest(mode) == shown.back());
                QVERIFY(*course.curve(course.rowOf({.angle = frame - 10}), mode) == shown.back());
            }
            QCOMPARE(*course.flicker(mode), otfFlicker(shown));
        }
    }

    void flickerIsOfTheNewestFrames() {
        OtfCourse course;
        std::vector<SampledCurve> all;
        for (int frame = 0; frame < 45; ++frame) {
            QCOMPARE(course.flicker(MotionOtf::eachView).has_value(), frame >= 3);
            course.add({.angle = frame}, curveOfFrame(frame * frame));
            all.push_back(curveOfFrame(frame * frame));
        }
        QCOMPARE(*course.flicker(MotionOtf::eachView), otfFlicker(std::span(all).last(OtfCourse::flickerFrames)));
    }

    void aStepOfThreeGoesOnAndAStepOfFourIsAJump() {
        OtfCourse course;
        OtfHistory history(OtfSmoothing::mean);
        course.add({.angle = 0}, curveOfFrame(0));
        course.add({.angle = -3}, curveOfFrame(1));
        (void)history.add(0, curveOfFrame(0));
        QVERIFY(course.newest(MotionOtf::mean) == history.add(3, curveOfFrame(1)));
        course.add({.angle = 1}, curveOfFrame(2));
        QVERIFY(course.newest(MotionOtf::mean) == curveOfFrame(2));
        QVERIFY(!course.flicker(MotionOtf::mean));
        QVERIFY(course.curve(45, MotionOtf::mean) != nullptr);  // the rows stay
    }

    void theSameFrameAgainTakesItsPlace() {
        OtfCourse course;
        OtfHistory history(OtfSmoothing::leastFlicker);
        course.add({.angle = 0}, curveOfFrame(0));
        course.add({.angle = 1}, curveOfFrame(7));
        course.add({.angle = 1}, curveOfFrame(1));
        (void)history.add(0, curveOfFrame(0));
        QVERIFY(course.newest(MotionOtf::leastFlicker) == history.add(1, curveOfFrame(1)));
    }

    void phasesFollowEachOtherOverAndOver() {
        OtfCourse course;
        course.begin(OtfCourse::Rows::phases, 20);
        QCOMPARE(course.rowCount(), 20);
        OtfHistory history(OtfSmoothing::mean);
        for (int frame = 17; frame < 25; ++frame) {
            course.add({.phase = frame % 20, .phases = 20}, curveOfFrame(frame));
            QVERIFY(course.newest(MotionOtf::mean) == history.add(frame, curveOfFrame(frame)));
        }
        QCOMPARE(course.numberOf(*course.presentRow()), 5);
        QVERIFY(course.curve(10, MotionOtf::mean) == nullptr);
    }

    void oneOtfDoesNotFlicker() {
        OtfCourse course;
        QVERIFY(!course.flicker(MotionOtf::oneOtf));
        course.addOneOtf({.angle = 2}, curveOfFrame(0));
        QCOMPARE(*course.flicker(MotionOtf::oneOtf), 0.0);
        QVERIFY(course.curve(47, MotionOtf::oneOtf) != nullptr);
        QVERIFY(course.curve(47, MotionOtf::eachView) == nullptr);
    }

    void theMapHasARowForEachFrame() {
        OtfCourse course;
        OtfMapCanvas map(course);
        map.setMode(MotionOtf::mean);
        for (int angle = -45; angle <= -20; ++angle) course.add({.angle = angle}, curveOfFrame(angle));
        const QImage image = map.image();
        for (int angle = -45; angle <= 45; ++angle) {
            const QRgb pixel = image.pixel(128, 45 - angle);  // the last row on top
            QCOMPARE(qAlpha(pixel), angle <= -20 ? 255 : 0);
            if (angle > -20) continue;
            const double opacity = course.curve(angle + 45, MotionOtf::mean)->opacities[128];
            QCOMPARE(qRed(pixel), static_cast<int>(std::lround(255 * opacity)));
        }
    }

    void theMapSaysWhatIsPointedAt() {
        OtfCourse course;
        OtfCoursePanel panel(course);
        panel.resize(430, 520);
        panel.show();
        QVERIFY(QTest::qWaitForWindowExposed(&panel));
        course.add({.angle = 0}, SampledCurve{std::vector<double>(256, 0.25)});
        panel.setMode(MotionOtf::eachView);
        panel.showCourse();
        auto* map = child<OtfMapCanvas>(panel, "motion.map");
        auto* reading = child<QLabel>(panel, "motion.map.reading");
        const QPoint middle = map->plotRect().center().toPoint();
        QTest::mouseMove(map, middle);
        QTRY_VERIFY2(reading->text().startsWith("0°, intensity 0.5"), qPrintable(reading->text()));
        QVERIFY(reading->text().endsWith("opacity 0.25"));
        QTest::mouseMove(map, {middle.x(), static_cast<int>(map->plotRect().top()) + 3});
        QTRY_COMPARE(reading->text(), "");  // no such frame yet
    }

    void theCurvesAreThoseOfTheEndsTheMiddleAndNow() {
        OtfCourse course;
        OtfCurvesCanvas curves(course);
        curves.setMode(MotionOtf::leastFlicker);
        QVERIFY(curves.shownRows().empty());
        for (int angle = -45; angle <= 12; ++angle) course.add({.angle = angle}, curveOfFrame(angle));
        QCOMPARE(curves.shownRows(), (std::vector<int>{0, 45, 57}));
        for (int angle = 13; angle <= 45; ++angle) course.add({.angle = angle}, curveOfFrame(angle));
        course.add({.angle = 44}, curveOfFrame(1));
        QCOMPARE(curves.shownRows(), (std::vector<int>{0, 45, 90, 89}));
    }

    void thePanelComparesTheModes() {
        OtfCourse course;
        OtfCoursePanel panel(course);
        panel.show();
        QCOMPARE(child<QLabel>(panel, "motion.map.flicker.mean")->text(), "–");
        panel.hide();
        for (int angle = 0; angle < 20; ++angle) course.add({.angle = angle}, curveOfFrame(angle));
        panel.setMode(MotionOtf::mean);
        panel.showCourse();
        panel.show();  // what was hidden meanwhile is made up for
        for (const auto& [name, mode] : {std::pair{"motion.map.flicker.eachView", MotionOtf::eachView},
                                         std::pair{"motion.map.flicker.mean", MotionOtf::mean}})
            QCOMPARE(child<QLabel>(panel, name)->text(), QLocale().toString(*course.flicker(mode), 'f', 4));
        QVERIFY(child<QLabel>(panel, "motion.map.flicker.mean")->font().bold());
        QVERIFY(!child<QLabel>(panel, "motion.map.flicker.eachView")->font().bold());
    }

    void everythingHasAnAccessibleName() {
        OtfCourse course;
        OtfCoursePanel panel(course);
        for (const char* name : {"motion.map", "motion.map.curves", "motion.map.rows", "motion.map.reading",
                                 "motion.map.flicker.static", "motion.map.flicker.leastFlicker"})
            QVERIFY2(!child<QWidget>(panel, name)->accessibleName().isEmpty(), name);
    }
};

ECHOLUCENT_TEST_CLASS(TestOtfCourse)
#include "test_otf_course.moc"
