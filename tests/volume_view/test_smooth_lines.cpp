// Lines over the 3D picture whose ends lie far beside it, as near the plane of the eye in perspective.
#include <vtkActor2D.h>
#include <QTest>

#include <cmath>
#include <limits>

#include "tests/qt_program/test_classes.h"
#include "widgets/volume_view/scene/annotation/smooth_lines.h"

using namespace echolucent;

class TestSmoothLines : public QObject {
    Q_OBJECT

private slots:
    void dashesBesideTheViewportTakeNoTime() {
        for (const double far : {1e6, 1e17, 1e300}) {
            SmoothLines lines;
            lines.setViewport(400, 300);
            lines.addDashedPath({{far, 150}, {-far, 150}}, 2.0, {255, 255, 255}, 6.0, 4.0);
            // The viewport and the margin beside it are 528 pixels wide: a rim, and a dash each 10 pixels.
            QVERIFY2(lines.bandCount() >= 54 && lines.bandCount() <= 55,
                     qPrintable(QString::number(lines.bandCount())));
        }
        SmoothLines none;
        none.setViewport(400, 300);
        const double infinite = std::numeric_limits<double>::infinity();
        none.addDashedPath({{infinite, 10}, {20, 10}, {std::nan(""), 4}}, 2.0, {255, 255, 255}, 6.0, 4.0);
        none.addPath({{1e17, 500}, {-1e17, 500}}, 2.0, {255, 255, 255});
        QCOMPARE(none.bandCount(), 0);
    }

    void dashesGoOnOverABendAndOverWhatIsClipped() {
        SmoothLines whole, bent, clipped;
        for (SmoothLines* lines : {&whole, &bent, &clipped}) lines->setViewport(400, 300);
        whole.addDashedPath({{0, 10}, {95, 10}}, 2.0, {255, 255, 255}, 6.0, 4.0);
        QCOMPARE(whole.bandCount(), 1 + 10);
        // The bend lies in a gap: 5 dashes before it, and 5 behind.
        bent.addDashedPath({{0, 10}, {48, 10}, {48, 57}}, 2.0, {255, 255, 255}, 6.0, 4.0);
        QCOMPARE(bent.bandCount(), 2 + 10);
        // The second dash begins at x = 399, in the last half pixel of the path.
        clipped.addDashedPath({{-10001, 10}, {399.5, 10}}, 2.0, {255, 255, 255}, 100.0, 10300.0);
        QCOMPARE(clipped.bandCount(), 2);
    }
};

ECHOLUCENT_TEST_CLASS(TestSmoothLines)
#include "test_smooth_lines.moc"
